from knifetip.messages import Message
from knifetip.model.verdict import Severity
from knifetip.verification.findings import MAX_FINDINGS, Findings

FAULT = Message("verify.unclassified")
WIDE = Message("verify.wide-slit", length=1.0, width=6.0)


def test_shortfalls_do_not_displace_a_fault() -> None:
    findings = Findings()
    for edge in range(MAX_FINDINGS + 5):
        findings.add("kerf", WIDE, 1.0, edge=edge, severity=Severity.SHORTFALL)
    assert (len(findings), findings.full) == (MAX_FINDINGS, False)
    findings.add("uncut", FAULT, 2.0, edge=3)
    assert len(findings) == MAX_FINDINGS + 1
    assert findings.sorted()[0].kind == "uncut"


def test_findings_are_sorted_by_severity_and_program_line() -> None:
    findings = Findings()
    findings.add("planned", WIDE, 0.0, severity=Severity.NOTE)
    findings.add("kerf", WIDE, 1.0, line=1, severity=Severity.SHORTFALL)
    findings.add("uncut", FAULT, 2.0)
    findings.add("uncut", FAULT, 3.0, line=7)
    findings.add("uncut", FAULT, 4.0, line=5)
    assert [finding.measure for finding in findings.sorted()] == [4.0, 3.0, 2.0, 1.0, 0.0]


def test_only_notes_do_not_refuse_the_program() -> None:
    findings = Findings()
    for severity in Severity:
        findings.add("kerf", WIDE, 1.0, severity=severity)
    assert [found.refuses for found in findings.sorted()] == [True, True, False]


def test_the_list_is_full_of_faults_only() -> None:
    findings = Findings()
    for edge in range(MAX_FINDINGS):
        findings.add("kerf", WIDE, 1.0, edge=edge, severity=Severity.SHORTFALL)
    assert (len(findings), findings.full) == (MAX_FINDINGS, False)
    findings.add_faults((line, FAULT) for line in range(MAX_FINDINGS))
    assert (len(findings), findings.full) == (2 * MAX_FINDINGS, True)
