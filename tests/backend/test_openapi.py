"""openapi.json is generated; the page's client is generated from it."""

from backend import openapi


def test_openapi_json_is_what_the_code_says() -> None:
    assert openapi.PATH.read_text() == openapi.text(), (
        "openapi.json is stale. Run: python -m backend.openapi"
    )


def test_every_operation_has_a_readable_name_and_says_how_it_refuses() -> None:
    document = openapi.document()
    for path, methods in document["paths"].items():
        for method, operation in methods.items():
            where = f"{method} {path}"
            assert operation["operationId"].isidentifier(), where
            assert operation["summary"], where
            schema = operation["responses"]["422"]["content"]["application/json"]["schema"]
            assert schema == {"$ref": "#/components/schemas/Problem"}, where


def test_no_generic_validation_error_is_left_in_the_interface() -> None:
    assert "HTTPValidationError" not in openapi.document()["components"]["schemas"]
