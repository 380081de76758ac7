"""Reading of valid, invalid and hostile settings files."""

import time

import pytest

from tests.devices.trex.settings.samples import TREX, TREX_JR, factory
from trex_gui.core.files import LARGEST_FILE, SettingsError, Severity
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.reader import MAX_FINDINGS, read_settings
from trex_gui.devices.trex.settings.writer import write_settings

TIMEOUT_RANGE = "serial_timeout: must be 0 to 127 (off to 12.7 s)"
UART_RANGE = "must be a baud rate, error detection and stop bits (low four bits 0 to 10)"
PRODUCT_CHOICE = "line 1: product: must be TReX or TReX Jr"
EITHER_PRODUCT = "'product: TReX' or 'product: TReX Jr'"
FOREIGN = "line 1: these are not settings of a TReX, which begin with 'product: TReX'"


def rejection_of(text: str | bytes) -> SettingsError:
    """Return the error of a rejected file."""
    with pytest.raises(SettingsError) as caught:
        read_settings(text)
    return caught.value


def only_error(text: str | bytes) -> str:
    """Return the text of the only error. Warnings are ignored."""
    findings = rejection_of(text).findings
    (error,) = (finding for finding in findings if finding.severity is Severity.ERROR)
    return str(error)


# --- Valid files -------------------------------------------------------------------------


def test_partial_file_is_read_with_count_of_missing_parameters() -> None:
    text = "product: TReX Jr\nfirmware: 1.2\nserial_timeout: 5\nmotor_mode: 1\n"
    settings, findings = read_settings(text)
    assert settings == Settings(TREX_JR, "1.2", {"serial_timeout": 5, "motor_mode": 1})
    (warning,) = findings
    assert str(warning) == (
        "warning: 26 of 28 parameters are missing: "
        "device_number, required_channels, ignored_channels …"
    )


def test_file_without_firmware_may_lack_newer_parameter() -> None:
    parameters = dict(factory(firmware=None).parameters)
    del parameters["uart_response_delay"]
    settings = Settings(TREX, None, parameters)
    assert read_settings(write_settings(settings)) == (settings, ())


def test_unterminated_last_line_is_read_with_warning() -> None:
    settings, findings = read_settings("product: TReX\n\nserial_timeout: 1")
    assert settings.parameters == {"serial_timeout": 1}
    assert (
        str(findings[0])
        == "line 3: warning: the last line has no line break; was the file cut short?"
    )


def test_unknown_firmware_gives_warning() -> None:
    settings, findings = read_settings("product: TReX\nfirmware: 1.10\n")
    assert settings.firmware == "1.10"
    expected = "line 2: warning: firmware: versions 1.0 to 1.3 are known, but 1.10 is not"
    assert str(findings[0]) == expected


# --- Invalid files -----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("setting", "sentence"),
    [
        ("serial_timeout: 300", f"{TIMEOUT_RANGE}, not 300"),
        ("serial_timeout: 1.5", f"{TIMEOUT_RANGE}, not 1.5"),
        ("serial_timeout: 1.5 s", f"{TIMEOUT_RANGE}, not 1.5 s; write 15 for 1.5 s"),
        (
            "serial_timeout: 1,000 ms",
            f"{TIMEOUT_RANGE}, not 1,000 ms; 1,000 is ambiguous: write 1 or 1000",
        ),
        ("serial_timeout: '5'", f"{TIMEOUT_RANGE}, not 5 in quotes; write 5"),
        ("serial_timeout:", f"{TIMEOUT_RANGE}, not nothing"),
        ("serial_timeout: [5]", f"{TIMEOUT_RANGE}, not a list"),
        ("serial_timeout: {a: 5}", f"{TIMEOUT_RANGE}, not a group of settings"),
        ("serial_timeout: |\n  5", f"{TIMEOUT_RANGE}, not a block of text"),
        ("device_number: 010", "device_number: must be 0 to 127, not 010"),
        ("device_number: true", "device_number: must be 0 to 127, not true"),
        (f"device_number: {'9' * 5000}", f"device_number: must be 0 to 127, not {'9' * 40}…"),
        (
            "motor_mode: joint",
            "motor_mode: must be 0 (independent) or 1 (joint), not joint; write 1 for joint",
        ),
        ("uart_error_shutdown: yes", "uart_error_shutdown: must be 0 (off) or 1 (on), not yes"),
        ("uart_settings: 0xFFF", f"uart_settings: {UART_RANGE}, not 0xFFF"),
        (
            "crc7_polynomial: 0x89",
            "crc7_polynomial: must be 0 to 127 (0x80 to 0xFF), not 0x89; write 9 for 0x89",
        ),
        (
            "serial_timeot: 5",
            "serial_timeot: there is no such setting; did you mean serial_timeout?",
        ),
        ("hovercraft: 5", "hovercraft: there is no such setting"),
        ("factory_reset: 127", "factory_reset: is a command to the board, not a setting"),
        ("firmware: new", "firmware: must be a version such as 1.3, not new"),
        ("[a, b]: 5", "there must be a name before the colon, not a list or a group"),
        (
            "rc_channel_1: 5",
            (
                "rc_channel_1: must be written as {minimum: …, neutral: …, maximum: …, "
                "deadband: …}, not 5"
            ),
        ),
        ("rc_channel_1: {minimum: 1, neutral: 2, maximum: 3}", "rc_channel_1: deadband is missing"),
        (
            "rc_channel_1: {}",
            "rc_channel_1: minimum and neutral and maximum and deadband are missing",
        ),
        (
            "rc_channel_1: {minimum: 1, neutral: 2, maximum: 3, deadband: 0, minimun: 5}",
            "rc_channel_1: a calibration has no 'minimun'; did you mean minimum?",
        ),
        (
            "rc_channel_1: {minimum: 1, neutral: 2, maximum: 3, deadband: 0, neutral: 5}",
            "rc_channel_1: neutral was already given in line 2",
        ),
        (
            "rc_channel_1: {minimum: 1, neutral: 2, maximum: 16384, deadband: 0}",
            "rc_channel_1: maximum must be 0 to 16383, not 16384",
        ),
        (
            "rc_channel_1: {minimum: 1, neutral: 2, maximum: 3, deadband: {a: 1}}",
            "this is nested too deeply; settings are plain 'key: value' lines",
        ),
        (
            "analog_channel_1: {minimum: 3, neutral: 2, maximum: 4, deadband: 0}",
            "analog_channel_1: minimum 3 is above neutral 2",
        ),
    ],
)
def test_invalid_setting_is_reported_with_line_and_reason(setting: str, sentence: str) -> None:
    assert only_error(f"product: TReX\n{setting}\n") == f"line 2: {sentence}"


def test_repeated_setting_is_reported_with_first_line() -> None:
    text = "product: TReX\nserial_timeout: 5\n\nserial_timeout: 5\n"
    assert only_error(text) == "line 4: serial_timeout: was already given in line 2"


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        (
            "product: Tic T825\ncontrol_mode: serial\n",
            f"{PRODUCT_CHOICE}, not Tic T825; these are not settings of a TReX",
        ),
        ("product: trex jr\n", f"{PRODUCT_CHOICE}, not trex jr; did you mean TReX Jr?"),
        ("product:\n", f"{PRODUCT_CHOICE}, not nothing; these are not settings of a TReX"),
        (
            "\nserial_timeout: 5\n",
            f"line 1: the first setting must be {EITHER_PRODUCT}, but this file has no product",
        ),
        (
            "serial_timeout: 5\nproduct: TReX\n",
            "line 2: product: must be the first setting of the file",
        ),
        ("", "line 1: there are no settings here; the first must be 'product: TReX'"),
        *((text, FOREIGN) for text in ("TReX\n", "- TReX\n", "[board]\nx = 1\n")),
        ("# QGroundControl\n1\t1\tACRO_BAL_PITCH\t1.0\t9\n1\t1\tX\t3\t9\n", FOREIGN),
        ("INPUT_MODE\tSERIAL\nINPUT_MINIMUM\t0\n", FOREIGN),
    ],
)
def test_file_must_begin_with_known_product(text: str, sentence: str) -> None:
    assert only_error(text) == sentence


def test_tabs_that_yaml_allows_are_read() -> None:
    text = (
        "product:\tTReX\t# tab\n\t\n \t# tab\nserial_timeout\t: 15\t\n"
        "rc_channel_1:\t{minimum: 1,\tneutral: 2, maximum:\t3, deadband: 4}\n"
    )
    settings, _ = read_settings(text)
    assert settings.parameters == {"serial_timeout": 15}
    assert settings.calibrations == {CalibrationKey.RC_CHANNEL_1: Calibration(1, 2, 3, 4)}


def test_parameter_of_newer_firmware_is_reported() -> None:
    text = "product: TReX Jr\nfirmware: 1.1\nuart_response_delay: 0\n"
    assert only_error(text) == (
        "line 3: uart_response_delay: a TReX Jr has this setting only from firmware 1.2 on, "
        "but the file is for 1.1"
    )


def test_parameter_of_other_product_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    rows = {row["key"]: row for row in device_table().rows}
    monkeypatch.setitem(rows["uart_response_delay"], "models", ["trex"])
    text = "product: TReX Jr\nfirmware: 1.1\nuart_response_delay: 0\n"
    assert only_error(text) == (
        "line 3: uart_response_delay: a TReX Jr does not have this setting in any firmware"
    )


def test_all_findings_are_reported_in_line_order() -> None:
    text = (
        "firmware: 1.2\nproduct: trex\nspeed: 1\nserial_timeout: 300\nmotor_mode: 1\n"
        "motor_mode: 1\nrc_channel_1:\n  minimum: x\n  neutral: 2\n  maximum: y\n  deadband: 0"
    )
    error = rejection_of(text)
    assert [finding.line for finding in error.findings] == [2, 2, 3, 4, 6, 8, 10, 11, None]
    keys = [finding.key for finding in error.findings]
    assert keys[2:7] == ["speed", "serial_timeout", "motor_mode", "rc_channel_1", "rc_channel_1"]
    severities = [finding.severity for finding in error.findings]
    assert severities == [Severity.ERROR] * 7 + [Severity.WARNING] * 2


def test_findings_have_codes_for_programs() -> None:
    text = "product: TReX\nserial_timeot: 1\nserial_timeout: 300\nrc_channel_1: {minimum: 1}"
    codes = [finding.code for finding in rejection_of(text).findings]
    assert codes == [
        "key_unknown",
        "value_invalid",
        "fields_missing",
        "unterminated",
        "parameters_missing",
    ]


def test_error_contains_file_name() -> None:
    with pytest.raises(SettingsError) as caught:
        read_settings("", "bench.txt")
    assert caught.value.name == "bench.txt"
    assert str(caught.value).startswith("bench.txt: line 1: ")
    with pytest.raises(SettingsError) as caught:
        read_settings("product: TReX\nspeed: 1\nwidth: 1\n", "bench.txt")
    assert str(caught.value).splitlines() == ["bench.txt:", *map(str, caught.value.findings)]


# --- Hostile files -----------------------------------------------------------------------


BOMB = "product: TReX\na: &a [1, 1]\nb: &b [*a, *a, *a]\nc: [*b, *b, *b]\n"


@pytest.mark.parametrize(
    ("text", "line", "words"),
    [
        (BOMB, 2, "anchors"),
        ("product: TReX\nrc_channel_1: {minimum: &a 5}\n", 2, "anchors"),
        ("&a product: TReX\n", 1, "anchors"),
        ("product: !!str TReX\n", 1, "tags"),
        ("product: TReX\n\na: !!python/object/apply:os.system ['true']\n", 3, "tags"),
        ("product: TReX\nserial_timeout: ! 5\n", 2, "tags"),
        ("product: TReX\n<<: {serial_timeout: 5}\n", 2, "merge keys"),
        ("product: TReX\n--- \nproduct: TReX\n", 2, "a second document"),
        ("[" * 5000, 1, "nested too deeply"),
        ("product: TReX\nx: " + "{a: " * 5000, 2, "nested too deeply"),
        ("product: TReX\nx: [[[ 'no end\n", 2, "nested too deeply"),  # the open quote comes later
        ("- " * 5000, 1, "nested too deeply"),
        ("? " * 5000, 1, "nested too deeply"),
        ("product: TReX\nx: [" + "1, " * 60000 + "]\n", 2, "more settings here than any board"),
        (b"product: TReX\nfirm\x00ware: 1\n", 2, "binary"),
        (b"\x00product: TReX\n", 1, "binary"),
        ("product: TReX\n".encode("utf-16"), 1, "this is UTF-16 text"),
        (b"product: TReX\n# 30 \xb5s\n", 2, "not UTF-8"),
        ("product: TReX\n# \ud800\n", 2, "not UTF-8"),
        ("product: TReX\n\n\x1b[2J", 3, "U+001B is not allowed"),
        ("product: TReX\n\tserial_timeout: 5\n", 2, "a tab indents this line"),
        ("product:TReX\nmotor_mode: 1\n", 1, "an ordinary space after the colon"),
        ("product:\xa0TReX\nmotor_mode: 1\n", 1, "an ordinary space after the colon"),
        ("product: TReX\nx: ]\ny:1\n", 2, "damaged here"),
        ("product: TReX\nserial_timeout 5\nmotor_mode: 1\n", 3, "damaged here"),
        ("product: TReX\nrc_channel_1: {minimum: 1, neu", 2, "is incomplete"),
        ('product: TReX\na: "\\UFFFFFFFF"\n', 2, "cannot be read"),
        (f"%YAML {'9' * 5000}.1\n---\nproduct: TReX\n", 1, "cannot be read"),
    ],
)
def test_unsupported_content_is_rejected_with_its_line(
    text: str | bytes, line: int, words: str
) -> None:
    (finding,) = rejection_of(text).findings
    assert words in finding.message
    assert finding.line == line


@pytest.mark.parametrize("text", ["#" * (LARGEST_FILE + 1), b"#" * (LARGEST_FILE + 1)])
def test_oversized_file_is_rejected_before_parsing(text: str | bytes) -> None:
    assert only_error(text) == "is larger than 256 KiB; settings are never that large"


def test_file_of_maximum_size_is_read() -> None:
    text = "product: TReX\n#".ljust(LARGEST_FILE - 1, "#") + "\n"
    settings, _ = read_settings(text)
    assert settings == Settings(TREX)


def test_many_errors_are_reported_quickly_and_briefly() -> None:
    count = 500
    text = "product: TReX\n" + "".join(f"serial_timeot_{n}: 1\n" for n in range(count))
    start = time.process_time()  # excludes the time of other processes
    error = rejection_of(text)
    assert time.process_time() - start < 5
    assert len(error.findings) <= MAX_FINDINGS + 2
    assert str(error.findings[-1]) == f"{count - MAX_FINDINGS} more errors are not listed"


def test_long_names_and_values_are_shortened_in_messages() -> None:
    long = "x" * 50_000
    error = rejection_of(f"product: TReX\n? {long}\n: 1\nserial_timeout: {long}\n")
    assert len(str(error)) < 500


def test_messages_contain_no_control_characters() -> None:
    error = rejection_of('product: TReX\n"\\e[2J": 1\nserial_timeout: "\\e[2J\\n"\n')
    assert all(line.isprintable() for line in str(error).split("\n"))
