# SPDX-License-Identifier: GPL-3.0-or-later
"""Descriptions for machines: an RO-Crate 1.1 of the files, studies and claims of an archive, and CodeMeta 2.0."""
import hashlib
import math
import re
import subprocess

ENCODINGS = {".tsv": "text/tab-separated-values", ".svg": "image/svg+xml", ".pdf": "application/pdf", ".json": "application/json",
             ".info": "text/plain", ".txt": "text/plain", ".md": "text/markdown", ".cff": "application/yaml", "": "text/plain"}
LICENCE = "https://spdx.org/licenses/GPL-3.0-or-later"
AUTHORS = {"@id": "#maintainers", "@type": "Organization", "name": "The microslip maintainers"}
SOFTWARE = {"@id": "#microslip"}


def citation(root, key):
    return re.search(rf'^{key}: "?(.*?)"?$', (root / "CITATION.cff").read_text(encoding="utf-8"), re.MULTILINE)[1]


def first_line_of(*command):
    try:
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()[0]
    except (OSError, subprocess.CalledProcessError, IndexError):
        return "unknown"


def environment(studies):
    """Programs and libraries by which the tables and figures were made."""
    made_by = sorted({f"{key}: {study.provenance[key]}" for study in studies
                      for key in ("compiler", "libraries", "processor") if key in study.provenance})
    return "; ".join([*made_by, f"figures: {first_line_of('gnuplot', '--version')}"])


def file_entity(name, data, what):
    suffix = "." + name.rpartition(".")[2] if "." in name.rpartition("/")[2] else ""
    return {"@id": name, "@type": "File", "name": what.get(name, name), "encodingFormat": ENCODINGS[suffix],
            "contentSize": str(len(data)), "sha256": hashlib.sha256(data).hexdigest()}


def claim_entity(study, claim):
    measured = "nothing but rounding" if claim.is_rounding else repr(claim.measured_value)
    entity = {"@id": f"#{claim.id}", "@type": "Claim", "name": claim.claim, "appearance": {"@id": f"tables/{study.name}/claims.tsv"},
              "description": f"{claim.verdict.replace('_', ' ')}: measured {measured}. Rule: {claim.rule}. {claim.note}"}
    if not math.isnan(claim.thesis_value):
        entity["alternateName"] = f"in the thesis, {claim.section}: {claim.thesis_value!r}"
    return entity


def action_entity(study, names):
    results = [name for name in names if name.startswith((f"tables/{study.name}/", f"figures/{study.name}_"))]
    return {"@id": f"#run-{study.name}", "@type": "CreateAction", "name": study.question, "instrument": SOFTWARE,
            "object": {"@id": f"scenes/{study.name}/study.info"}, "result": [{"@id": name} for name in results],
            "description": study.command}


def crate(root, version, studies, files):
    """The metadata of an archive.
    files: name: bytes, without the metadata and the sums
    """
    what = {f"tables/{study.name}/{table.name}.tsv": table.description for study in studies for table in study.tables}
    what["article.pdf"] = "[Re] Improving CONTACT for varying timesteps"
    entities = [file_entity(name, data, what) for name, data in sorted(files.items())]
    claims = [claim_entity(study, claim) for study in studies for claim in study.claims]
    actions = [action_entity(study, sorted(files)) for study in studies]
    thesis = {"@id": "#thesis", "@type": "Thesis", "name": "Improving CONTACT for varying timesteps", "datePublished": "2017",
              "author": {"@id": "#wekken"}}
    software = {**SOFTWARE, "@type": "SoftwareApplication", "name": "microslip", "version": version, "license": {"@id": LICENCE},
                "softwareRequirements": environment(studies), "description": studies[0].provenance["program"].partition(", ")[2]}
    dataset = {"@id": "./", "@type": "Dataset", "name": f"Results of microslip {version}", "description": citation(root, "title"),
               "datePublished": citation(root, "date-released"), "license": {"@id": LICENCE}, "author": {"@id": AUTHORS["@id"]},
               "citation": {"@id": thesis["@id"]}, "hasPart": [{"@id": entity["@id"]} for entity in entities],
               "mentions": [{"@id": entity["@id"]} for entity in actions + claims]}
    descriptor = {"@id": "ro-crate-metadata.json", "@type": "CreativeWork", "about": {"@id": "./"},
                  "conformsTo": {"@id": "https://w3id.org/ro/crate/1.1"}}
    licence = {"@id": LICENCE, "@type": "CreativeWork", "name": "GNU General Public License, version 3 or later"}
    writer = {"@id": "#wekken", "@type": "Person", "name": "Niels van der Wekken"}
    return {"@context": "https://w3id.org/ro/crate/1.1/context",
            "@graph": [descriptor, dataset, AUTHORS, licence, software, thesis, writer, *actions, *claims, *entities]}


def codemeta(root, version):
    keywords = re.findall(r"^  - (\w.*)$", (root / "CITATION.cff").read_text(encoding="utf-8").partition("keywords:")[2]
                          .partition("references:")[0], re.MULTILINE)
    return {"@context": "https://doi.org/10.5063/schema/codemeta-2.0", "@type": "SoftwareSourceCode", "name": "microslip",
            "description": citation(root, "title"), "version": version, "license": LICENCE,
            "datePublished": citation(root, "date-released"), "programmingLanguage": ["C++", "C", "Python"],
            "operatingSystem": "Linux", "keywords": keywords, "author": [{"@type": "Organization", "name": AUTHORS["name"]}],
            "softwareRequirements": ["Eigen", "Boost", "FFTW", "GSL", "fmt"]}
