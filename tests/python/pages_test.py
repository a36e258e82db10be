# SPDX-License-Identifier: GPL-3.0-or-later
"""The code of docs/python.md runs, from top to bottom."""
import re

import pytest


@pytest.mark.filterwarnings("ignore::microslip.LoadWarning")
def test_code_of_the_page_runs(source):
    pytest.importorskip("matplotlib").use("Agg")
    text = (source / "docs" / "python.md").read_text()
    blocks = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    assert len(blocks) > 5
    names = {}
    for block in blocks:
        exec(compile(block, "docs/python.md: " + block.partition("\n")[0], "exec"), names)
    assert names["states"].size == 40 and len(names["instants"]) == 6
