"""The queue of a machine on the page: its order, hold, priority, copies, and another machine."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

import httpx
import pytest
from playwright.sync_api import Locator, Page, Route, expect

from tests.browser.conftest import Running
from tests.browser.own_machine import OwnMachine
from tests.support.serving.server import confirm_job

pytestmark = [
    pytest.mark.browser,
    pytest.mark.xdist_group("browser"),
    pytest.mark.timeout(600),
]

NAMES = ("first.dxf", "second.dxf", "third.dxf")
LIST_OF_ORDERS = re.compile(r"/api/v1/orders(\?|$)")


class Queue(NamedTuple):
    """A machine with three waiting jobs, the other machine, and their list on the page."""

    machine: OwnMachine
    other: OwnMachine
    jobs: list[str]
    list: Locator


@pytest.fixture(scope="module")
def machines(server: Running) -> Iterator[tuple[OwnMachine, OwnMachine, list[str]]]:
    headers = {"X-Knifetip": "page"}
    with httpx.Client(base_url=server.url, timeout=60.0, trust_env=False, headers=headers) as api:
        machine, other = OwnMachine(api, "queue-table"), OwnMachine(api, "second-table")
        yield machine, other, [machine.upload(name) for name in NAMES]


@pytest.fixture
def queue(
    page: Page, server: Running, machines: tuple[OwnMachine, OwnMachine, list[str]]
) -> Iterator[Queue]:
    machine, other, drawings = machines
    jobs = [machine.order(drawing) for drawing in drawings]
    page.evaluate("localStorage.setItem('knifetip.operator', 'Mia')")
    page.get_by_test_id("to-machines").click()
    try:
        expect(rows_of(page, machine)).to_have_count(3)
        yield Queue(machine, other, jobs, page.get_by_test_id(f"queue-of-{machine.name}"))
    finally:
        machine.clear()
        other.clear()


def rows_of(page: Page, machine: OwnMachine) -> Locator:
    return page.get_by_test_id(f"queue-of-{machine.name}").get_by_test_id("queue-row")


def row(queue: Queue, name: str) -> Locator:
    return queue.list.locator("li", has_text=name)


def expect_order(queue: Queue, *names: str) -> None:
    expect(queue.list.get_by_test_id("queue-row")).to_contain_text(list(names))
    at = dict(zip(NAMES, queue.jobs, strict=True))
    assert queue.machine.queue() == [at[name] for name in names]


def who(queue: Queue, name: str) -> str:
    """Return who has changed a job last."""
    id = queue.jobs[NAMES.index(name)]
    return str(queue.machine.api.get(f"/api/jobs/{id}/events").json()[-1]["who"])


def choose(queue: Queue, name: str, item: str) -> None:
    """Choose an item in the menu of a job, again if the menu moved under the pointer."""
    button = row(queue, name).get_by_test_id("queue-more")
    target = queue.list.page.get_by_role("menuitem", name=item, exact=True)
    button.click()
    for _ in range(3):
        target.click()
        try:
            expect(target).to_be_hidden(timeout=5_000)
        except AssertionError:
            continue
        else:
            return
    raise AssertionError(f"The menu of {name} stays open.")


def test_jobs_are_moved_by_buttons_and_by_dragging(queue: Queue) -> None:
    expect_order(queue, "first.dxf", "second.dxf", "third.dxf")
    # The id that the ERP uses for the job.
    expect(queue.list.get_by_test_id("queue-id")).to_have_text(queue.jobs)
    expect(row(queue, "first.dxf").get_by_test_id("move-up")).to_be_disabled()
    expect(row(queue, "third.dxf").get_by_test_id("move-down")).to_be_disabled()
    row(queue, "third.dxf").get_by_test_id("move-up").click()
    expect_order(queue, "first.dxf", "third.dxf", "second.dxf")
    assert who(queue, "third.dxf") == "operator Mia"
    drag_with_mouse(grip(queue, "second.dxf"), grip(queue, "first.dxf"))
    expect_order(queue, "second.dxf", "first.dxf", "third.dxf")
    choose(queue, "third.dxf", "Move to the top")
    expect_order(queue, "third.dxf", "second.dxf", "first.dxf")


def grip(queue: Queue, name: str) -> Locator:
    return row(queue, name).get_by_test_id("drag-job")


def centre(locator: Locator) -> tuple[float, float]:
    locator.scroll_into_view_if_needed()
    box = locator.bounding_box()
    assert box is not None
    return box["x"] + box["width"] / 2.0, box["y"] + box["height"] / 2.0


def drag_with_mouse(source: Locator, target: Locator) -> None:
    mouse = source.page.mouse
    mouse.move(*centre(source))
    mouse.down()
    mouse.move(*centre(target), steps=8)
    mouse.up()


def test_jobs_are_moved_with_a_finger_and_with_the_keyboard(queue: Queue) -> None:
    page = queue.list.page
    expect_order(queue, "first.dxf", "second.dxf", "third.dxf")
    (x, y), (to_x, to_y) = centre(grip(queue, "third.dxf")), centre(grip(queue, "first.dxf"))
    touch = page.context.new_cdp_session(page)

    def send(kind: str, *points: tuple[float, float]) -> None:
        touch_points = [{"x": x, "y": y} for x, y in points]
        touch.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": touch_points})

    send("touchStart", (x, y))
    # Held until the row is lifted; a finger that moves at once would scroll the list.
    expect(page.locator("[data-dragged=true]")).to_have_count(1)
    for step in range(1, 9):
        send("touchMove", (x + (to_x - x) * step / 8.0, y + (to_y - y) * step / 8.0))
    send("touchEnd")
    expect_order(queue, "third.dxf", "first.dxf", "second.dxf")

    grip(queue, "third.dxf").focus()
    page.keyboard.press("Space")
    expect(page.locator("[data-dragged=true]")).to_have_count(1)
    for place in (2, 3):
        page.keyboard.press("ArrowDown")
        expect(page.get_by_text(f"third.dxf: place {place} of 3")).to_be_attached()
    page.keyboard.press("Space")
    expect_order(queue, "first.dxf", "second.dxf", "third.dxf")


@pytest.mark.long
def test_a_move_in_an_order_that_has_changed_is_refused_and_shown(queue: Queue) -> None:
    page = queue.list.page
    moved: list[str] = []

    def change_first(route: Route) -> None:
        # Another person is faster, so the displayed order is out of date.
        if not moved:
            moved.append(queue.jobs[2])
            body = {"previous": "", "next": queue.jobs[0], "by": "Ben"}
            queue.machine.api.post(f"/api/jobs/{queue.jobs[2]}/move", json=body).raise_for_status()
        route.continue_()

    page.route(re.compile(r"/api/v1/jobs/[^/]+/move$"), change_first)
    row(queue, "second.dxf").get_by_test_id("move-up").click()
    expect(page.get_by_test_id("report")).to_contain_text(re.compile("order|queue", re.I))
    expect_order(queue, "third.dxf", "first.dxf", "second.dxf")
    row(queue, "second.dxf").get_by_test_id("move-up").click()
    expect_order(queue, "third.dxf", "second.dxf", "first.dxf")


def test_a_job_is_held_and_gets_a_priority_and_copies(queue: Queue) -> None:
    first, _, third = queue.jobs
    row(queue, "first.dxf").get_by_test_id("queue-hold").click()
    expect(row(queue, "first.dxf")).to_have_attribute("data-hold", "true")
    assert queue.machine.job(first)["waiting_for"] == "hold"
    assert who(queue, "first.dxf") == "operator Mia"
    assert queue.machine.claim()["job"] == queue.jobs[1]
    row(queue, "first.dxf").get_by_test_id("queue-hold").click()
    expect(row(queue, "first.dxf")).to_have_attribute("data-hold", "false")

    choose(queue, "third.dxf", "Urgent")
    expect(row(queue, "third.dxf")).to_contain_text("Urgent")
    assert queue.machine.job(third)["priority"] > 0
    expect(row(queue, "third.dxf")).to_have_attribute("data-place", "1")

    copies = row(queue, "third.dxf").get_by_test_id("queue-copies")
    copies.press("ControlOrMeta+a")
    copies.press_sequentially("7")
    copies.press("Enter")
    expect(row(queue, "third.dxf")).to_contain_text("7 copies")
    assert queue.machine.job(third)["copies"] == 7


@pytest.mark.long
def test_a_job_is_moved_to_another_machine(queue: Queue) -> None:
    page = queue.list.page
    # A window in which the menu does not fit: it scrolls inside the window.
    page.set_viewport_size({"width": 1440, "height": 320})
    row(queue, "second.dxf").get_by_test_id("queue-more").click()
    box = page.get_by_role("menu").bounding_box()
    assert box is not None
    assert box["y"] >= 0.0
    assert box["y"] + box["height"] <= 320.0
    page.keyboard.press("Escape")
    expect(page.get_by_role("menu")).to_be_hidden()
    choose(queue, "second.dxf", queue.other.title)
    expect_order_of_other = page.get_by_test_id(f"queue-of-{queue.other.name}")
    expect(expect_order_of_other).to_contain_text("second.dxf", timeout=60_000)
    expect(queue.list.get_by_test_id("queue-row")).to_have_count(2)
    moved = queue.machine.job(queue.jobs[1])
    assert (moved["machine"], moved["state"]) == (queue.other.name, "queued")
    assert queue.other.queue() == [queue.jobs[1]]


def test_a_machine_shows_its_head_and_what_is_made_of_its_job(
    page: Page, server: Running, machines: tuple[OwnMachine, OwnMachine, list[str]]
) -> None:
    machine, _, _ = machines
    job = machine.order()
    claim = machine.claim()
    confirm_job(machine.api, job).raise_for_status()
    page.goto(f"{server.url}/#/machines/{machine.name}")
    picture = page.get_by_test_id("table-picture")
    left, done = picture.get_by_test_id("work-left"), picture.get_by_test_id("work-done")
    expect(left).to_have_attribute("d", re.compile("^M"))
    program = machine.api.get(f"/api/jobs/{job}/program").text.split("\n")
    shares = []
    moves = [at for at, line in enumerate(program, 1) if re.match(r"G1 X[-\d.]+ Y", line)]
    for line in (moves[len(moves) // 3], moves[2 * len(moves) // 3]):
        found = re.search(r"X([-\d.]+) ?Y([-\d.]+)", program[line - 1])
        assert found is not None
        x, y = (float(part) for part in found.groups())
        # The height holds until a line has another one.
        heights = re.findall(r"Z([-\d.]+)", "\n".join(program[:line]))
        machine.report(claim, line, position=[x, y, float(heights[-1]), 0.0])
        head = picture.get_by_test_id("table-head")
        expect(head).to_have_attribute("data-x", f"{x:.2f}", timeout=20_000)
        expect(head).to_have_attribute("data-y", f"{y:.2f}", timeout=20_000)
        expect(done).to_have_attribute("d", re.compile("^M"))
        made, rest = (len(str(one.get_attribute("d"))) for one in (done, left))
        shares.append(made / (made + rest))
    assert 0.0 < shares[0] < shares[1] < 1.0
    machine.clear()


def expect_in_work(page: Page, machine: OwnMachine) -> None:
    """Expect a queued job of a machine in the table of work, also among drawings of one file."""
    expect(page.get_by_test_id("drawing-row").first).to_be_visible()
    for button in page.get_by_test_id("duplicates").all():
        button.click()
    row = page.get_by_test_id("drawing-row").filter(has_text=machine.title)
    expect(row.get_by_text("Queued").filter(visible=True)).to_have_count(1)


@pytest.mark.long
def test_a_job_added_while_the_page_loads_its_list_is_shown(
    page: Page, machines: tuple[OwnMachine, OwnMachine, list[str]]
) -> None:
    _, machine, _ = machines
    added: list[str] = []

    def answer_late(route: Route) -> None:
        # The event about the job arrives before the answer, which does not contain the job.
        answer = route.fetch()
        if not added:
            added.append(machine.order())
            page.wait_for_timeout(1000)
        route.fulfill(response=answer)

    page.route(LIST_OF_ORDERS, answer_late)
    page.reload()
    expect_in_work(page, machine)
    page.unroute_all(behavior="wait")
    machine.clear()


@pytest.mark.long
def test_a_list_that_could_not_be_loaded_is_loaded_later(
    page: Page, machines: tuple[OwnMachine, OwnMachine, list[str]]
) -> None:
    _, machine, _ = machines
    machine.order()
    refusals: list[int] = []

    def refuse(route: Route) -> None:
        if len(refusals) < 5:
            refusals.append(503)
            route.fulfill(status=503, body="")
        else:
            route.continue_()

    page.route(LIST_OF_ORDERS, refuse)
    page.reload()
    expect_in_work(page, machine)
    page.unroute_all(behavior="wait")
    machine.clear()
