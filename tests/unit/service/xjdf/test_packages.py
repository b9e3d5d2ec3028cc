"""Orders in packages: ZIP as XJDF 2.x describes it, and MIME multipart/related."""

from __future__ import annotations

import io
import struct
import zipfile
from email.mime.application import MIMEApplication
from email.mime.multipart import MIMEMultipart
from email.policy import HTTP

import httpx
import pytest

from knifetip.errors import RequestError
from knifetip.service.xjdf.package import MimePackage, ZipPackage, open_package
from tests.support.serving.server import square
from tests.unit.service.xjdf.test_xjdf import ORDER

ZIP = "application/vnd.cip4-xjdf+zip"


def order_for(url: str, number: str = "PO-4711") -> bytes:
    text = ORDER.replace("/api/v1/drawings/d7placeholder", url).replace("PO-4711", number)
    return text.encode()


def zipped(files: dict[str, bytes], *, method: int = zipfile.ZIP_DEFLATED) -> bytes:
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", method) as package:
        for name, data in files.items():
            package.writestr(name, data)
    return content.getvalue()


def related(
    document: bytes, drawing: bytes, subtype: str = "vnd.cip4-xjdf+xml"
) -> tuple[str, bytes]:
    """Return Content-Type and body of a package that Python's email library has written."""
    message = MIMEMultipart("related")
    message.attach(MIMEApplication(document, subtype))
    part = MIMEApplication(drawing, "dxf")
    part["Content-ID"] = "<tray@erp.example>"
    message.attach(part)
    head, _, body = message.as_bytes(policy=HTTP).partition(b"\r\n\r\n")
    (media,) = (
        line.partition(": ")[2]
        for line in head.decode().replace("\r\n ", " ").splitlines()
        if line.startswith("Content-Type")
    )
    return media, body


def post(client: httpx.Client, content: bytes, media: str, key: str = "") -> httpx.Response:
    headers = {"Content-Type": media, **({"Idempotency-Key": key} if key else {})}
    return client.post("/api/v1/xjdf", content=content, headers=headers)


@pytest.mark.parametrize("url", ["art/tray%20%C3%BC.dxf", "./art/tray ü.dxf"])
def test_a_zip_with_order_and_drawing_becomes_a_job(client: httpx.Client, url: str) -> None:
    files = {
        "jobs/order.xjdf": order_for(url),
        "art/tray ü.dxf": square(side=71.0),
        "preview.pdf": b"not read",
    }
    answer = post(client, zipped(files), ZIP, f"zip-{len(url)}")
    assert answer.status_code == 201, answer.text
    job = answer.json()
    assert (job["external_id"], job["copies"]) == ("PO-4711", 3)
    drawing = client.get(f"/api/v1/drawings/{job['drawing']}").json()
    assert (drawing["name"], drawing["customer"]) == ("tray ü.dxf", "K-12")
    stored = client.get(f"/api/v1/drawings/{job['drawing']}/file")
    assert stored.status_code == 404 or stored.content == square(side=71.0)
    assert post(client, zipped(files), ZIP, f"zip-{len(url)}").json()["id"] == job["id"]


def test_a_mime_package_becomes_a_job(client: httpx.Client) -> None:
    media, body = related(order_for("cid:tray@erp.example"), square(side=72.0))
    answer = post(client, body, media)
    assert answer.status_code == 201, answer.text
    assert answer.json()["external_id"] == "PO-4711"


def test_binary_parts_of_a_mime_package_are_not_changed() -> None:
    drawing = bytes(range(256)) * 3 + b"\r\n\n\r--x"
    body = (
        b"--AA\r\nContent-ID: <order>\r\n\r\n<XJDF/>\r\n--AA\r\nContent-Location: a/b.pdf\r\n"
        b"Content-Transfer-Encoding: binary\r\n\r\n" + drawing + b"\r\n--AA--\r\n"
    )
    package = MimePackage(body, 'multipart/related; boundary=AA; start="<order>"')
    assert package.root == b"<XJDF/>"
    assert package.file("a/b.pdf") == drawing


def fault(content: bytes, media: str = ZIP, kind: str = "XJDF") -> str:
    def read() -> bytes:
        return open_package(content, media, 1 << 20, kind).file("tray.dxf")

    with pytest.raises(RequestError) as refused:
        read()
    assert "\x1b" not in refused.value.text
    return refused.value.message.code


@pytest.mark.parametrize(
    "name",
    ["../tray.dxf", "/etc/passwd", "a/../../b", "..\\tray.dxf", "C:/tray.dxf", "\x1b[31m", "a\nb"],
)
def test_names_that_lead_out_of_the_package_are_refused(name: str) -> None:
    assert fault(zipped({"order.xjdf": b"<XJDF/>", name: b""})) == "xjdf.bad-name"


def test_a_bomb_is_not_decompressed() -> None:
    bomb = {"order.xjdf": b"<XJDF/>", "tray.dxf": bytes(200 << 20)}
    content = zipped(bomb)
    assert len(content) < 1 << 20
    assert fault(content) == "xjdf.too-large"
    # A wrong size in the directory does not help.
    at = content.rindex(b"PK\x01\x02")
    forged = content[: at + 24] + struct.pack("<I", 10) + content[at + 28 :]
    assert fault(forged) in ("xjdf.too-large", "xjdf.bad-package")
    huge = zipped({"order.xjdf": b"<XJDF>" + bytes(100 << 20)})
    assert fault(huge) == "xjdf.too-large"


def test_what_is_no_package_is_refused() -> None:
    good = zipped({"order.xjdf": b"<XJDF/>", "tray.dxf": b"x" * 100}, method=zipfile.ZIP_STORED)
    assert ZipPackage(good, 1 << 20, "XJDF").file("tray.dxf") == b"x" * 100
    encrypted = bytearray(good)
    for mark, place in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
        at = encrypted.find(mark)
        while at >= 0:
            encrypted[at + place] |= 1
            at = encrypted.find(mark, at + 4)
    assert fault(bytes(encrypted)) == "xjdf.bad-package"
    assert fault(good.replace(b"x" * 100, b"y" * 100)) == "xjdf.bad-package"  # check sum
    assert fault(good[:-30]) == "xjdf.bad-package"
    assert fault(b"no zip") == "xjdf.bad-package"
    assert fault(zipped({"tray.dxf": b""})) == "xjdf.wrong-count"
    assert fault(zipped({"a.xjdf": b"", "b.xjdf": b""})) == "xjdf.wrong-count"
    assert fault(zipped({"order.xjmf": b""}), kind="XJMF") == "xjdf.wrong-count"
    many = {f"{index}.dxf": b"" for index in range(300)}
    assert fault(zipped({"order.xjdf": b"", **many})) == "xjdf.many-files"
    assert fault(zipped({"order.xjdf": b"<XJDF/>"})) == "xjdf.no-file"
    for media in ("multipart/related", "multipart/related; boundary=A", "multipart/related;;="):
        assert fault(b"--B\r\n\r\n", media) == "xjdf.no-parts"
    assert fault(b"--A\r\n\r\n<XJDF/>\r\n--A--", "multipart/related; boundary=A; start=x") == (
        "xjdf.no-file"
    )
    nested = (
        b"--A\r\nContent-Type: multipart/mixed; boundary=B\r\n\r\n--B\r\n\r\n1\r\n--B--\r\n--A--"
    )
    assert fault(nested, "multipart/related; boundary=A") == "xjdf.nested-parts"
    assert fault(b"<XJDF/>", "application/xml") == "xjdf.no-file"


@pytest.mark.parametrize("url", ["file:///etc/passwd", "http://erp.example/a.dxf", "//erp/a.dxf"])
def test_files_of_other_systems_are_not_fetched(client: httpx.Client, url: str) -> None:
    answer = post(client, zipped({"order.xjdf": order_for(url)}), ZIP)
    assert (answer.status_code, answer.json()["code"]) == (422, "xjdf.bad-value")


def test_a_package_may_be_as_large_as_an_upload(client: httpx.Client) -> None:
    files = {"order.xjdf": order_for("a.dxf"), "a.dxf": b"no drawing", "b": bytes(20 << 20)}
    answer = post(client, zipped(files, method=zipfile.ZIP_STORED), ZIP)
    assert answer.status_code == 422, answer.text
    assert answer.json()["code"] == "error.in-file"


@pytest.mark.parametrize("method", [zipfile.ZIP_LZMA, zipfile.ZIP_BZIP2])
def test_methods_of_compression_that_xjdf_does_not_permit(method: int) -> None:
    files = {"order.xjdf": b"<XJDF/>", "tray.dxf": b"x" * 1000}
    whole = zipped(files, method=method)
    assert fault(whole) == "xjdf.bad-package"
    # Damaged data of the other methods raise errors of their own.
    at = whole.index(b"order.xjdf") + 20
    assert fault(whole[:at] + b"\xff" * 8 + whole[at + 8 :]) == "xjdf.bad-package"


def test_a_file_without_a_name_is_no_fault_of_the_server() -> None:
    content = bytearray(zipped({"order.xjdf": b"<XJDF/>", "x": b""}))
    # The names in the directory begin after 46 bytes; the zip library cuts them at a zero.
    content[content.rindex(b"PK\x01\x02") + 46] = 0
    assert fault(bytes(content)) == "xjdf.bad-name"


def test_a_directory_with_very_many_files_is_not_read(monkeypatch: pytest.MonkeyPatch) -> None:
    many = b"PK\x01\x02" * 20_000
    monkeypatch.setattr(zipfile, "ZipFile", None)
    assert fault(b"PK\x03\x04" + many) == "xjdf.many-files"


@pytest.mark.parametrize("kind", [b"multipart/mixed; boundary=A", b"message/rfc822"])
def test_parts_in_parts_in_parts_are_refused(kind: bytes) -> None:
    body = b"--A\r\n\r\n<XJDF/>\r\n--A\r\n" + (b"Content-Type: " + kind + b"\r\n\r\n") * 5000
    deep = b"".join(
        b"--%d\r\nContent-Type: multipart/mixed; boundary=%d\r\n\r\n" % (level, level + 1)
        for level in range(3000)
    )
    for content, boundary in ((body, "A"), (deep, "0")):
        code = fault(content, f"multipart/related; boundary={boundary}")
        assert code in ("xjdf.bad-package", "xjdf.nested-parts", "xjdf.no-file")
