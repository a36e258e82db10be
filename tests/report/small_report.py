# SPDX-License-Identifier: GPL-3.0-or-later
"""A report of two studies, which is quickly read: tests damage it in many ways and look whether that is found."""
import sys
from unittest import mock

from quick_results import REPORT, claims_of

sys.path.insert(0, str(REPORT.parent))
import report

STUDIES = ("carter", "open_problems")


def small_report(results, studies=STUDIES):
    """The text of the page that there would be if these studies were the only ones."""
    faults = [fault for fault in report.FAULTS if fault.study in studies]
    with mock.patch.multiple(report, questions=lambda: studies, FAULTS=faults):
        return report.report(results)


def small_claims(results):
    """Rows of the claims tables of these studies, by the id of their card."""
    return {id: claim for id, claim in claims_of(results).items() if id.rpartition("-")[0] in STUDIES}
