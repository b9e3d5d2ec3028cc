"""Own machines, boards and tools on the page: copy, edit, conflicts, files, and jobs with them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest
from playwright.sync_api import Locator, Page, expect

from knifetip.dxf.samples import samples
from tests.browser.conftest import Running

pytestmark = [pytest.mark.browser, pytest.mark.xdist_group("browser"), pytest.mark.timeout(600)]


@pytest.fixture
def api(server: Running) -> Iterator[httpx.Client]:
    headers = {"X-Knifetip": "page"}
    with httpx.Client(base_url=server.url, timeout=60.0, trust_env=False, headers=headers) as one:
        yield one


def open_entry(page: Page, server: Running, name: str) -> None:
    page.goto(f"{server.url}/#/library")
    page.get_by_test_id(f"entry-{name}").click()
    expect(page.get_by_test_id("copy-definition")).to_be_visible()


def copy(page: Page, server: Running, source: str, name: str) -> None:
    """Copy an entry, and wait until the copy is open."""
    open_entry(page, server, source)
    page.get_by_test_id("copy-definition").click()
    page.get_by_test_id("copy-title").fill(name.capitalize())
    page.get_by_test_id("copy-name").fill(name)
    page.get_by_test_id("copy-save").click()
    expect(page.get_by_text(f"{name} · version 1")).to_be_visible()


def field(page: Page, path: str) -> Locator:
    return page.locator(f'[data-path="{path}"]')


def save(page: Page, version: int) -> None:
    page.get_by_role("button", name=f"Save as version {version}").click()


def definition(api: httpx.Client, path: str) -> dict[str, Any]:
    found: dict[str, Any] = api.get(f"/api/{path}/definition").json()
    return found


def test_a_copy_has_the_name_that_the_person_chooses(
    page: Page, server: Running, api: httpx.Client
) -> None:
    open_entry(page, server, "e-flute")
    page.get_by_test_id("copy-definition").click()
    name, made = page.get_by_test_id("copy-name"), page.get_by_test_id("copy-save")
    page.get_by_test_id("copy-title").fill("Wellpappe Größe 5")
    expect(name).to_have_value("wellpappe-grosse-5")
    name.fill("b-flute")
    expect(page.get_by_text("There is a board with this name.")).to_be_visible()
    expect(made).to_be_disabled()
    name.fill("Our Board")
    expect(page.get_by_text("small letters, digits")).to_be_visible()
    name.fill("copy-of-e")
    made.click()
    expect(page.get_by_text("copy-of-e · version 1")).to_be_visible()
    own = definition(api, "boards/copy-of-e")
    shipped = definition(api, "boards/e-flute")
    assert own["title"] == "Wellpappe Größe 5"
    assert {**own["fields"], "title": ""} == {**shipped["fields"], "title": ""}


def test_a_fault_is_shown_beside_its_field_and_nothing_is_saved(
    page: Page, server: Running, api: httpx.Client
) -> None:
    copy(page, server, "greyboard-2.0", "faulty-board")
    # The operator is asked once, and recorded with the version.
    page.evaluate("localStorage.setItem('knifetip.operator', 'Ada')")
    depth = field(page, "half_cut_depth")
    depth.fill("2.5")
    save(page, 2)
    expect(depth).to_have_attribute("aria-invalid", "true")
    expect(depth).to_be_focused()
    message = page.locator(".mantine-InputWrapper-error")
    expect(message).to_have_count(1)
    expect(message).to_contain_text("This value is 2.5")
    expect(page.get_by_test_id("definition-fault")).to_contain_text("1 value needs a correction")
    assert definition(api, "boards/faulty-board")["version"] == 1
    depth.fill("1.25")
    page.get_by_label("What is changed, and why").fill("deeper half-cuts")
    save(page, 2)
    expect(page.get_by_text("faulty-board · version 2")).to_be_visible()
    expect(message).to_have_count(0)
    assert definition(api, "boards/faulty-board")["fields"]["half_cut_depth"] == 1.25
    newest = api.get("/api/boards/faulty-board/versions").json()[0]
    assert (newest["by"], newest["note"]) == ("Ada", "deeper half-cuts")
    page.get_by_test_id("compare-1").click()
    expect(page.get_by_test_id("differences")).to_contain_text("half_cut_depth")


def test_two_persons_change_one_board(page: Page, server: Running, api: httpx.Client) -> None:
    copy(page, server, "greyboard-1.5", "shared-board")

    def change_elsewhere(version: int, **changed: object) -> None:
        fields = definition(api, "boards/shared-board")["fields"] | changed
        answer = api.put(
            "/api/boards/shared-board?by=Ben",
            json=fields,
            headers={"If-Match": f'"{version}"'},
        )
        assert answer.status_code == 200, answer.text

    change_elsewhere(1, bridge_width=0.4, bridge_spacing=80)
    field(page, "double_crease").fill("1.5")
    save(page, 2)
    conflict = page.get_by_test_id("conflict")
    expect(conflict).to_contain_text("Ben has saved version 2")
    expect(conflict).to_contain_text("bridge_width")
    expect(conflict).to_contain_text("double_crease")
    assert definition(api, "boards/shared-board")["version"] == 2
    page.get_by_test_id("take-theirs").click()
    expect(field(page, "bridge_width")).to_have_value("0.4")
    expect(conflict).to_be_hidden()

    field(page, "double_crease").fill("1.2")
    change_elsewhere(2, groove_pass=1)
    save(page, 3)
    expect(conflict).to_contain_text("Ben has saved version 3")
    page.get_by_test_id("keep-mine").click()
    expect(page.get_by_text("shared-board · version 4")).to_be_visible()
    kept = definition(api, "boards/shared-board")["fields"]
    assert (kept["double_crease"], kept.get("groove_pass", 0)) == (1.2, 0)


def test_a_definition_goes_through_a_file(
    page: Page, server: Running, api: httpx.Client, tmp_path: Path
) -> None:
    copy(page, server, "v-cutter-45", "file-tool")
    with page.expect_download() as download:
        page.get_by_test_id("download-definition").click()
    assert download.value.suggested_filename == "file-tool.toml"
    text = Path(download.value.path()).read_text("utf-8")
    assert text == api.get("/api/tools/file-tool/toml").text
    changed = tmp_path / "file-tool-2.toml"
    changed.write_text(text.replace("tilt = 45", "tilt = 30"), "utf-8")
    # The shelf of an open tool is that of tools.
    chosen = page.locator("input[type=file]")
    chosen.set_input_files(changed)
    expect(page.get_by_text("file-tool-2 · version 1")).to_be_visible()
    assert definition(api, "tools/file-tool-2")["fields"]["tool"]["tilt"] == 30.0
    broken = tmp_path / "broken.toml"
    broken.write_text('title = "x"\n[tool]\nkind = "saw"\n', "utf-8")
    chosen.set_input_files(broken)
    expect(page.get_by_role("alert")).to_contain_text("saw")


def test_a_job_is_made_with_an_own_machine_and_a_tool_of_the_library(
    page: Page, server: Running, api: httpx.Client
) -> None:
    copy(page, server, "demo-table", "own-table")
    page.get_by_test_id("tool-picker").first.click()
    page.get_by_role("option", name="Static knife, 2 mm blade").click()
    tool = "station 1 → tool → "
    expect(field(page, f"{tool}blade_width")).to_have_value("2")
    field(page, f"{tool}blade_width").fill("2.4")
    save(page, 2)
    expect(page.get_by_text("own-table · version 2")).to_be_visible()
    saved = definition(api, "machines/own-table")["fields"]["station"][0]["tool"]
    shipped = definition(api, "tools/static-knife")["fields"]["tool"]
    assert saved == {**shipped, "blade_width": 2.4}

    name = "rigid-box-blank.dxf"
    drawing = api.post("/api/drawings", files={"file": (name, samples()[name])}).json()["id"]
    page.goto(f"{server.url}/#/drawings/{drawing}")
    page.get_by_test_id("machine-select").click()
    page.get_by_role("option", name="Own-table").click()
    page.get_by_test_id("board-select").click()
    page.get_by_role("option", name="Greyboard 2.0 mm").click()
    page.get_by_test_id("compile").click()
    expect(page.get_by_test_id("send")).to_be_visible(timeout=60_000)
    (job,) = [one for one in api.get("/api/jobs").json() if one["drawing"] == drawing]
    assert (job["machine"], job["machine_version"], job["state"]) == ("own-table", 2, "ready")


@pytest.mark.long
def test_the_settings_of_a_controller_follow_its_language(
    page: Page, server: Running, api: httpx.Client
) -> None:
    copy(page, server, "flat-cutter-hpgl", "own-plotter")
    force = field(page, "controller → pen 1 → force")
    expect(force).to_have_value("30")
    field(page, "controller → device").click()
    page.get_by_role("option", name="Another, with these properties").click()
    save(page, 2)
    missing = page.locator("[aria-invalid=true]")
    expect(missing.first).to_be_visible()
    expect(field(page, "controller → device → units")).to_have_attribute("aria-invalid", "true")
    field(page, "controller → device").click()
    page.get_by_role("option", name="flat-cutter-centred").click()
    force.fill("99")
    save(page, 2)
    expect(force).to_have_attribute("aria-invalid", "true")
    field(page, "controller → device").click()
    page.get_by_role("option", name="flat-cutter", exact=True).click()
    force.fill("33")
    save(page, 2)
    expect(page.get_by_text("own-plotter · version 2")).to_be_visible()
    assert definition(api, "machines/own-plotter")["fields"]["controller"]["pen"][0]["force"] == 33
    field(page, "dialect").click()
    page.get_by_role("option", name="linuxcnc").click()
    expect(page.get_by_text("This controller language has no settings.")).to_be_visible()


@pytest.mark.long
def test_what_is_typed_and_added_in_the_form_is_what_is_saved(
    page: Page, server: Running, api: httpx.Client
) -> None:
    copy(page, server, "demo-table", "typed-table")
    field(page, "clearance").click()
    page.keyboard.press("Control+A")
    page.keyboard.type("2.75")  # "2." on the way is no number yet
    expect(field(page, "clearance")).to_have_value("2.75")
    field(page, "max_caliper").fill("8")
    field(page, "station 3 → tool").click()
    page.get_by_role("option", name="crease-wheel").click()
    field(page, "station 3 → tool → radius").fill("12")
    field(page, "station 3 → tool → width").fill("0.7")
    page.get_by_test_id("add-station").click()
    expect(field(page, "station 4 → number")).to_have_value("3")
    page.get_by_role("button", name="Remove station 4").click()
    expect(field(page, "station 4 → number")).to_have_count(0)
    shipped = definition(api, "machines/demo-table")["fields"]
    save(page, 2)
    expect(page.get_by_text("typed-table · version 2")).to_be_visible()
    saved = definition(api, "machines/typed-table")["fields"]
    tool = {"kind": "crease-wheel", "radius": 12, "width": 0.7, "feed": 12000, "plunge": 3000}
    assert saved["station"][2].pop("tool") == tool
    shipped["station"][2].pop("tool")
    # Nothing else is changed or added, also no default.
    assert saved == {**shipped, "title": "Typed-table", "clearance": 2.75, "max_caliper": 8}


def test_a_table_is_added_by_its_name_and_a_fault_is_shown_in_it(
    page: Page, server: Running, api: httpx.Client
) -> None:
    copy(page, server, "greyboard-4.0", "named-board")
    page.get_by_label("Name of the station").fill("Router 2")
    page.get_by_role("button", name="Add", exact=True).first.click()
    field(page, "deflection → Router 2 → x").fill("-1")
    save(page, 2)
    expect(field(page, "deflection → Router 2 → x")).to_have_attribute("aria-invalid", "true")
    expect(field(page, "deflection → Router 2 → y")).to_have_attribute("aria-invalid", "true")
    field(page, "deflection → Router 2 → x").fill("0.1")
    field(page, "deflection → Router 2 → y").fill("0.2")
    save(page, 2)
    expect(page.get_by_text("named-board · version 2")).to_be_visible()
    saved = definition(api, "boards/named-board")["fields"]["deflection"]
    assert saved == {"Router 2": {"x": 0.1, "y": 0.2}}
    page.get_by_role("button", name="Remove Router 2").click()
    save(page, 3)
    expect(page.get_by_text("named-board · version 3")).to_be_visible()
    assert "Router 2" not in definition(api, "boards/named-board")["fields"].get("deflection", {})


@pytest.mark.long
def test_a_gantry_with_a_second_carriage_is_added_in_the_form(
    page: Page, server: Running, api: httpx.Client
) -> None:
    copy(page, server, "router-table", "own-gantry")
    page.get_by_test_id("add-gantry").click()
    y = definition(api, "machines/own-gantry")["fields"]["axes"]["y"]
    field(page, "gantry → min_distance").fill("150")
    field(page, "gantry → park").fill(str(y["low"]))
    carriage = "gantry → carriage 1 → "
    field(page, f"{carriage}park").fill(str(y["low"] + 100))
    for axis, letter, low, high in (("y", "V", y["low"], y["high"]), ("c", "A", -720, 720)):
        field(page, f"{carriage}{axis} → letter").click()
        page.get_by_role("option", name=letter, exact=True).click()
        values = {"low": low, "high": high, "velocity": 900, "acceleration": 5000}
        for name, value in values.items():
            field(page, f"{carriage}{axis} → {name}").fill(str(value))
    save(page, 2)
    expect(page.get_by_text(re.compile("park.*150|150.*park")).first).to_be_visible()
    assert definition(api, "machines/own-gantry")["version"] == 1
    field(page, f"{carriage}park").fill(str(y["high"]))
    save(page, 2)
    expect(page.get_by_text("own-gantry · version 2")).to_be_visible()
    machine = next(one for one in api.get("/api/machines").json() if one["name"] == "own-gantry")
    assert [one["letters"] for one in machine["carriages"]] == ["XYZC", "XVZA"]


def test_the_deflection_of_a_cutter_is_computed_from_a_test_cut(
    page: Page, server: Running, api: httpx.Client
) -> None:
    copy(page, server, "greyboard-3.0", "measured-board")
    page.get_by_text("Compute the deflection from a test cut").click()
    for row, (dx, dy) in {0: (0, 0.05), 2: (-0.08, 0)}.items():
        page.get_by_test_id(f"dx-{row}").fill(str(dx))
        page.get_by_test_id(f"dy-{row}").fill(str(dy))
    page.get_by_test_id("compute").click()
    expect(page.get_by_test_id("calibration-result")).to_contain_text("0.0800 mm in X")
    page.get_by_test_id("use-deflection").click()
    expect(field(page, "deflection → Router → x")).to_have_value("0.08")
    save(page, 2)
    expect(page.get_by_text("measured-board · version 2")).to_be_visible()
    (deflection,) = api.get("/api/boards/measured-board").json()["deflection"]
    assert deflection["tool"] == "Router"
    assert (deflection["x"], deflection["y"]) == (pytest.approx(0.08), pytest.approx(0.05))


@pytest.mark.parametrize(
    ("address", "said", "back"),
    [
        ("library/machines/nowhere", "There is no machine named nowhere", "/#/library"),
        ("library/boards/nowhere", "There is no board named nowhere", "/#/library"),
        ("library/shelf/nowhere", "There is no such page", "/#/library"),
        ("station/nowhere", "There is no machine named nowhere", "/#/"),
        ("nowhere", "There is no such page", "/#/"),
    ],
)
def test_an_address_that_names_nothing_says_so(
    page: Page, server: Running, address: str, said: str, back: str
) -> None:
    page.goto(f"{server.url}/#/{address}")
    shown = page.get_by_test_id("not-found")
    expect(shown).to_contain_text(said)
    shown.get_by_role("link").click()
    expect(page).to_have_url(f"{server.url}{back}")
    expect(shown).to_have_count(0)


def test_an_entry_of_the_library_has_an_address(page: Page, server: Running) -> None:
    open_entry(page, server, "demo-table")
    expect(page).to_have_url(f"{server.url}/#/library/machines/demo-table")
    page.reload()
    expect(page.get_by_role("heading", level=1, name="Demo table 1600 × 1200")).to_be_visible()
