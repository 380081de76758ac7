"""Pose files in PyPose's format."""

from codecs import BOM_UTF8
from collections.abc import Iterable
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.matrix import examples
from trex_gui.core.files import Finding, Severity
from trex_gui.core.resource_files import resource
from trex_gui.devices.aracna.poses.ppr import read_file, read_ppr, write_ppr
from trex_gui.devices.aracna.poses.project import Pose, Project, Sequence, SequenceStep

HEADER = "Aracna:8:1024:1024:1024:1024:1024:1024:1024:1024\n"
EIGHT = "1, 2, 3, 4, 5, 6, 7, 8"
AS_PYPOSE_WRITES = (
    HEADER
    + f"Pose=a b:{EIGHT}\n"
    + "Pose=zero:0, 0, 0, 0, 0, 0, 0, 0\n"
    + "Seq=there: a b|500, zero|5000, p3|1\n"
    + "Seq=nothing: \n"
    + "Nuke=IK,walk\n"
)


def messages(findings: Iterable[Finding]) -> list[tuple[int | None, str]]:
    return [(finding.line, finding.message) for finding in findings]


def test_pypose_file_is_written_back_byte_for_byte() -> None:
    project, _ = read_ppr(AS_PYPOSE_WRITES)
    assert write_ppr(project) == AS_PYPOSE_WRITES


@pytest.mark.parametrize("first", ["Pose=a: 1, 2, 3, 4, 5, 6, 7, 8\n", "Aracna:8\n"])
def test_byte_order_mark_is_removed_from_first_line(tmp_path: Path, first: str) -> None:
    path = tmp_path / "marked.ppr"
    path.write_text(f"{first}Pose=b: 1, 2, 3, 4, 5, 6, 7, 8\n", encoding="utf-8-sig")
    project = read_file(path).project
    assert project.name == ("Aracna" if "Aracna" in first else "")
    assert [pose.name for pose in project.poses] == (["b"] if project.name else ["a", "b"])


@pytest.mark.parametrize("mark", [b"", BOM_UTF8], ids=["plain", "byte order mark"])
def test_text_in_other_encoding_is_reported_with_its_line(tmp_path: Path, mark: bytes) -> None:
    path = tmp_path / "old.ppr"
    path.write_bytes(mark + f"{HEADER}Pose=Füße:{EIGHT}".encode("latin-1"))
    file = read_file(path)
    assert [pose.name for pose in file.project.poses] == ["Füße"]
    [first] = file.findings
    assert "not in UTF-8" in first.message
    assert first.line == 2


def test_poses_sequences_and_robot_are_read() -> None:
    project, findings = read_ppr(AS_PYPOSE_WRITES.replace(", p3|1", ""))
    assert findings == ()
    assert (project.name, project.resolutions) == ("Aracna", (1024,) * 8)
    assert project.poses == (Pose("a b", (1, 2, 3, 4, 5, 6, 7, 8)), Pose("zero", (0,) * 8))
    steps = (SequenceStep("a b", 500), SequenceStep("zero", 5000))
    assert project.sequences == (Sequence("there", steps), Sequence("nothing"))
    assert project.rest == ("Nuke=IK,walk",)


def test_wrong_resolution_count_is_reported_and_set_to_1024() -> None:
    project, findings = read_ppr("Aracna:8:300:300\n")
    assert project.resolutions == (1024,) * 8
    [(line, message)] = messages(findings)
    assert line == 1
    assert "8 resolutions" in message
    assert "1024" in message


def test_missing_positions_become_512_with_warning() -> None:
    project, findings = read_ppr(HEADER + "Pose=short:1, 2, 3\n")
    assert project.poses == (Pose("short", (1, 2, 3, 512, 512, 512, 512, 512)),)
    [(line, message)] = messages(findings)
    assert line == 2
    assert "3 of 8 positions" in message
    assert findings[0].severity is Severity.WARNING
    assert read_ppr(HEADER + "Pose=none:\n")[0].poses == (Pose("none", (512,) * 8),)


def test_short_pose_is_written_padded_with_512() -> None:
    text = write_ppr(Project(poses=(Pose("short", (1, 2)),)))
    project, findings = read_ppr(text)
    assert findings == ()
    assert project.poses == (Pose("short", (1, 2, 512, 512, 512, 512, 512, 512)),)
    assert write_ppr(project) == text


def test_old_style_pose_is_read_and_written_in_new_style() -> None:
    project, findings = read_ppr(HEADER + f"stand:{EIGHT}\n")
    assert findings == ()
    assert project.poses == (Pose("stand", (1, 2, 3, 4, 5, 6, 7, 8)),)
    assert write_ppr(project) == HEADER + f"Pose=stand:{EIGHT}\n"


def test_undefined_poses_are_reported_with_line() -> None:
    project, findings = read_ppr(HEADER + "Seq=gait: p1|500, p2|500, p1|100\n")
    assert project.sequences[0].missing_poses(project.pose_names) == ("p1", "p2")
    assert [finding.line for finding in findings] == [2, 2]
    assert "p1" in findings[0].message
    assert "Seq=gait: p1|500, p2|500, p1|100\n" in write_ppr(project)


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("just words", "no colon"),
        (f"Pose=:{EIGHT}", "a pose needs a name"),
        ("Pose= :1, 2", "a pose needs a name"),
        ("Seq=: a|500", "a sequence needs a name"),
        ("Seq=no colon", "colon"),
        ("Pose=a:1, two, 3", "'two' (motor 1)"),
        ("Pose=a:1, 1024", "'1024' (motor 1)"),
        ("Pose=a:-1", "'-1' (motor 0)"),
        ("Pose=a:1,,3", "'' (motor 1)"),
        ("Pose=a:1_0", "'1_0'"),
        ("Pose=a:٣", "'٣'"),
        ("Seq=s: a|0", "'a|0'"),
        ("Seq=s: a|3600001", "'a|3600001'"),
        ("Seq=s: a", "'a'"),
        ("Seq=s: a|b|5", "'a|b|5'"),
        ("Seq=s: a|1.5", "'a|1.5'"),
    ],
)
def test_invalid_line_is_reported_with_number_and_kept(line: str, message: str) -> None:
    text = HEADER + f"Pose=good:{EIGHT}\n" + line + "\n"
    project, findings = read_ppr(text)
    assert [pose.name for pose in project.poses] == ["good"]
    assert project.sequences == ()
    [finding] = findings
    assert (finding.line, finding.severity) == (3, Severity.ERROR)
    assert message in finding.message
    assert "kept, but not used" in finding.message
    assert write_ppr(project) == text


def test_surplus_positions_are_kept_and_reported() -> None:
    text = HEADER + f"Pose=long:{EIGHT}, 9\n"
    project, findings = read_ppr(text)
    assert project.poses[0].for_motors(8) == (1, 2, 3, 4, 5, 6, 7, 8)
    assert "9 positions for 8" in findings[0].message
    assert write_ppr(project) == text


def test_first_of_two_poses_with_same_name_is_renamed() -> None:
    project, findings = read_ppr(HEADER + f"Pose=a:{EIGHT}\n" + "Pose=a:8, 2, 3, 4, 5, 6, 7, 8\n")
    assert [(pose.name, pose.positions[0]) for pose in project.poses] == [("a 2", 1), ("a", 8)]
    [(line, message)] = messages(findings)
    assert line == 2
    assert "line 3" in message


def test_blanks_around_names_are_ignored() -> None:
    project, findings = read_ppr(HEADER + f"Pose= sp :{EIGHT}\nSeq= s :  sp |500\n")
    assert findings == ()
    assert project.poses == (Pose("sp", (1, 2, 3, 4, 5, 6, 7, 8)),)
    assert project.sequences == (Sequence("s", (SequenceStep("sp", 500),)),)
    assert write_ppr(project) == HEADER + f"Pose=sp:{EIGHT}\nSeq=s: sp|500\n"


@pytest.mark.parametrize("lines", [("Pose=a:1\n", "Pose= a :2\n"), ("Pose= a :2\n", "Pose=a:1\n")])
def test_pose_differing_only_in_blanks_is_renamed(lines: tuple[str, str]) -> None:
    project, findings = read_ppr(HEADER + "".join(lines) + "Seq=s: a|500\n")
    assert {pose.name: pose.positions[0] for pose in project.poses} == {"a": 1, "a 2": 2}
    [finding] = [each for each in findings if "becomes a 2" in each.message]
    assert finding.severity is Severity.WARNING
    assert finding.line == 2 + [" a " in line for line in lines].index(True)
    assert project.sequences[0].missing_poses(project.pose_names) == ()


@pytest.mark.parametrize("text", ["", "\n", "Pose=a:1\n", "Aracna", "Aracna:many:1", "Aracna:0"])
def test_invalid_first_line_is_reported(text: str) -> None:
    project, findings = read_ppr(text)
    assert project.resolutions == (1024,) * 8
    assert findings[0].line == 1


def test_resolutions_of_other_servos_are_kept() -> None:
    project, findings = read_ppr("Bioloid:2:1024:4096\nPose=p:1, 2\n")
    assert findings == ()
    assert project.resolutions == (1024, 4096)


_NAMES = st.text(st.characters(exclude_characters=":\r\n", exclude_categories=["Cs"]), max_size=8)
_ITEM_NAMES = _NAMES.map(str.strip).filter(bool)
_REFERENCES = st.text(
    st.characters(exclude_characters=",|\r\n", exclude_categories=["Cs"]), max_size=8
).map(str.strip)
_POSITIONS = st.lists(st.integers(0, 1023), min_size=8, max_size=8).map(tuple)


@st.composite
def projects(draw: st.DrawFn) -> Project:
    poses = draw(
        st.lists(
            st.builds(Pose, _ITEM_NAMES, _POSITIONS), unique_by=lambda pose: pose.name, max_size=4
        )
    )
    steps = st.builds(SequenceStep, _REFERENCES, st.integers(1, 6000))
    sequences = st.builds(Sequence, _ITEM_NAMES, st.lists(steps, max_size=4).map(tuple))
    return Project(
        draw(_NAMES.filter(lambda name: not name.startswith(("Pose=", "Seq=", "Nuke=")))),
        poses=tuple(poses),
        sequences=tuple(
            draw(st.lists(sequences, unique_by=lambda sequence: sequence.name, max_size=3))
        ),
        line_end=draw(st.sampled_from(["\n", "\r\n", "\r"])),
    )


@examples(25)
@given(projects())
def test_written_project_is_read_back_equal(project: Project) -> None:
    found, findings = read_ppr(write_ppr(project))
    assert found == project
    assert all("is not in the file" in finding.message for finding in findings)


_LINES = st.one_of(
    st.text(max_size=20),
    st.sampled_from(["Pose=a:1, 2", "Pose=a:3", "Seq=s: a|5, b|6", "Seq=s: a|x", "Nuke=x", "b:1"]),
)


@examples(40)
@given(st.lists(_LINES, max_size=6).map("\n".join))
def test_unusable_lines_are_written_back_unchanged(text: str) -> None:
    project, findings = read_ppr(text)
    separator = "\n" if "\n" in text else "\r"
    lines = [line.removesuffix("\r") for line in text.split(separator)]
    for finding in findings:
        if finding.severity is Severity.ERROR:
            assert finding.line is not None
            assert lines[finding.line - 1] in write_ppr(project).split(project.line_end)


def test_sample_file_matches_pypose_format() -> None:
    text = resource("aracna/sample.ppr").read_text(encoding="utf-8")
    project, findings = read_ppr(text)
    assert findings == ()
    assert [sequence.name for sequence in project.sequences] == ["stand up", "star 6", "push-ups"]
    assert write_ppr(project) == text


def test_long_file_is_read_within_time_limit() -> None:
    """Every test has a time limit."""
    lines = "a:1\nSeq=a: b|1\nnothing\n"
    text = HEADER + lines * (256 * 1024 // len(lines))
    project, findings = read_ppr(text)
    assert len(findings) >= text.count("\n") - 2
    assert len(project.poses + project.sequences) + len(project.rest) == text.count("\n") - 1
