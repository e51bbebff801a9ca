#include "verify/operations/request_file.hpp"

#include <fmt/format.h>

#include "reference/text/file_kind.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/text_file.hpp"

namespace tps::operations {
namespace {

JsonDocument document_of(const Operation& operation, const std::string& path) {
  refuse_other_kinds_of_file(path, "the input of an operation", {FileKind::requests});
  return parse_json_file(path, is_of_numbers(operation)
                                   ? "the input of one operation is a small object"
                                   : "the input of one operation is an object of that operation");
}

}  // namespace

RequestFile::RequestFile(const Operation& operation, const std::string& path)
    : source_(display_name(path)), document_(document_of(operation, path)) {
  document_.problems.throw_if_any();
  const JsonValue* op = document_.root.find("op");
  if (document_.root.find("in") == nullptr || op == nullptr) return;
  if (op->string() != nullptr && *op->string() == operation.name) return;
  throw InputError({{source_, op->line, "/op",
                     fmt::format("the request is for another operation than {}", operation.name)}});
}

const JsonValue& RequestFile::in() const {
  const JsonValue* in = document_.root.find("in");
  return in == nullptr ? document_.root : *in;
}

Place RequestFile::place() const {
  return {source_, document_.root.find("in") == nullptr ? "" : "/in"};
}

}  // namespace tps::operations
