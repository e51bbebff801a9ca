// A file with the input of one operation.
#pragma once

#include <string>

#include "reference/text/json_document.hpp"
#include "verify/operations/input.hpp"

namespace tps::operations {

/// The object that the protocol calls "in", or a whole request that has it.
class RequestFile {
 public:
  /// "-" is standard input. Throws InputError with what is wrong with the file, or where its request is for
  /// another operation.
  RequestFile(const Operation& operation, const std::string& path);

  const JsonValue& in() const;
  Place place() const;

 private:
  std::string source_;
  JsonDocument document_;
};

}  // namespace tps::operations
