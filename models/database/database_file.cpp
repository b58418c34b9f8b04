// SPDX-License-Identifier: MIT
#include "models/database/database_file.hpp"

#include <algorithm>
#include <fstream>

#include "models/database/database_json.hpp"
#include "models/environment/input_error.hpp"
#include "models/environment/text_file.hpp"
#include "models/environment/write.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::json;

constexpr const char* kSceneTag = "cigsim";

enum class Form { kNeither, kText, kCbor };

Form form_of(const std::filesystem::path& file) {
  const std::string ending = lower_ending(file);
  return ending == "json" ? Form::kText : ending == "cbor" ? Form::kCbor : Form::kNeither;
}

[[noreturn]] void fail_on_ending(const std::filesystem::path& file) {
  throw InputError(file.string(), 0, "a prepared database ends in .json or .cbor");
}

// Looks among the keys of the outermost object for the tag of a database or of a scene, and stops
// there. The CBOR parser of the
// library recurses, so nesting that no database has ends the search.
class TagSearch : public nlohmann::json_sax<Json> {
 public:
  bool found() const { return found_; }
  bool too_deep() const { return too_deep_; }

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return enter(); }
  bool end_object() override { return leave(); }
  bool start_array(std::size_t) override { return enter(); }
  bool end_array() override { return leave(); }
  bool key(string_t& name) override {
    if (depth_ != 1) return true;
    found_ = name == kDatabaseTag;
    return !found_ && name != kSceneTag;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    return false;
  }

 private:
  static constexpr int kDeepest = 16;
  bool enter() {
    too_deep_ = ++depth_ > kDeepest;
    return !too_deep_;
  }
  bool leave() {
    --depth_;
    return true;
  }
  int depth_ = 0;
  bool found_ = false, too_deep_ = false;
};

// Meets every value, only to learn whether the nesting is one that the parser can stand.
class DepthSearch : public TagSearch {
 public:
  bool key(string_t&) override { return true; }
};

int line_of(const std::string& bytes, std::size_t position) {
  const auto end = bytes.begin() + static_cast<std::ptrdiff_t>(std::min(position, bytes.size()));
  return 1 + static_cast<int>(std::count(bytes.begin(), end, '\n'));
}

Json parse(const std::filesystem::path& file, Form form) {
  const std::string bytes = read_whole_file(file);
  if (form == Form::kCbor) {
    DepthSearch depth;
    Json::sax_parse(bytes, &depth, Json::input_format_t::cbor);
    if (depth.too_deep()) throw InputError(file.string(), 0, "is nested too deeply for a database");
  }
  try {
    return form == Form::kCbor ? Json::from_cbor(bytes) : Json::parse(bytes);
  } catch (const Json::parse_error& error) {
    const bool text = form == Form::kText;
    throw InputError(file.string(), text ? line_of(bytes, error.byte) : 0,
                     "is damaged or cut short at byte " + std::to_string(error.byte) +
                         "; prepare the scene again");
  } catch (const Json::exception& error) {
    throw InputError(file.string(), 0, std::string("cannot be used: ") + error.what());
  }
}

}  // namespace

bool is_database(const std::filesystem::path& file) {
  const Form form = form_of(file);
  std::ifstream in(file, std::ios::binary);
  if (form == Form::kNeither || !in) return false;
  TagSearch search;
  Json::sax_parse(in, &search,
                  form == Form::kCbor ? Json::input_format_t::cbor : Json::input_format_t::json);
  return search.found();
}

Database read_database(const std::filesystem::path& file) {
  const Form form = form_of(file);
  if (form == Form::kNeither) fail_on_ending(file);
  const Json value = parse(file, form);
  try {
    Database database = database_from_json(value);
    check_database(database);
    return database;
  } catch (const DatabaseFault& fault) {
    throw InputError(file.string(), 0, fault.what());
  }
}

void write_database(const Database& database, const std::filesystem::path& file) {
  const Form form = form_of(file);
  if (form == Form::kNeither) fail_on_ending(file);
  const nlohmann::ordered_json value = database_to_json(database);
  write_file(file, [&](std::ostream& out) {
    if (form == Form::kCbor)
      nlohmann::ordered_json::to_cbor(value, nlohmann::detail::output_adapter<char>(out));
    else
      out << value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
  });
}

}  // namespace cigsim
