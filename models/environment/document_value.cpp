// SPDX-License-Identifier: MIT
#include "models/environment/document_value.hpp"

namespace cigsim {

std::string_view kind_name(Document::Kind kind) {
  switch (kind) {
    case Document::Kind::object:
      return "an object {}";
    case Document::Kind::array:
      return "an array []";
    case Document::Kind::string:
      return "a text";
    case Document::Kind::whole:
    case Document::Kind::negative:
    case Document::Kind::real:
      return "a number";
    case Document::Kind::boolean:
      return "a truth value";
    default:
      return "null";
  }
}

}  // namespace cigsim
