// SPDX-License-Identifier: MIT
// Values of a document with the checks that every reader of ours makes: the right kind, the right
// range, no unknown key, no key twice. Every fault is an InputError with file and line.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "models/environment/document.hpp"
#include "models/environment/input_error.hpp"

namespace cigsim {

/// What a message calls a value of this kind.
std::string_view kind_name(Document::Kind kind);

/// A value of the document. `what` names it in messages.
class DocumentValue {
 public:
  DocumentValue(const Document& document, std::size_t at) : document_(&document), at_(at) {}

  Document::Kind kind() const { return entry().kind; }
  std::uint32_t line() const { return entry().line; }

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(document_->name(), static_cast<int>(line()), what);
  }

  void require(Document::Kind kind, std::string_view what) const {
    if (this->kind() != kind)
      fail(std::string(what) + " must be " + std::string(kind_name(kind)) + ", not " +
           std::string(kind_name(this->kind())));
  }

  const std::string& text(std::string_view what) const {
    require(Document::Kind::string, what);
    return document_->text(at_);
  }

  double number(std::string_view what) const {
    double value = 0;
    switch (kind()) {
      case Document::Kind::whole:
        value = static_cast<double>(entry().whole);
        break;
      case Document::Kind::negative:
        value = static_cast<double>(entry().negative);
        break;
      case Document::Kind::real:
        value = entry().real;
        break;
      default:
        fail(std::string(what) + " must be a number, not " + std::string(kind_name(kind())));
    }
    if (!std::isfinite(value)) fail(std::string(what) + " must be a finite number");
    return value;
  }

  /// A whole number from 0 to below `end`.
  std::uint64_t whole(std::string_view what, std::uint64_t end) const {
    if (kind() != Document::Kind::whole || entry().whole >= end)
      fail(std::string(what) + " must be a whole number from 0 to " + std::to_string(end - 1));
    return entry().whole;
  }

  template <class F>
  void for_each_element(std::string_view what, F&& f) const {
    require(Document::Kind::array, what);
    for (std::size_t i = at_ + 1; i < entry().whole; i = document_->after(i))
      f(DocumentValue(*document_, i));
  }

  std::size_t count() const {
    std::size_t n = 0;
    for (std::size_t i = at_ + 1; i < entry().whole; i = document_->after(i)) ++n;
    return n;
  }

  /// Calls f(key, key's place, value) for each member in the order of the text.
  template <class F>
  void for_each_member(std::string_view what, F&& f) const {
    require(Document::Kind::object, what);
    for (std::size_t i = at_ + 1; i < entry().whole; i = document_->after(i + 1))
      f(document_->text(i), DocumentValue(*document_, i), DocumentValue(*document_, i + 1));
  }

 private:
  const Document::Entry& entry() const { return document_->entry(at_); }

  const Document* document_;
  std::size_t at_;
};

/// The members of one kind of object: none unknown, none twice.
class DocumentMembers {
 public:
  DocumentMembers(const DocumentValue& value, std::string_view what,
                  std::initializer_list<std::string_view> known)
      : value_(value), what_(what) {
    value.for_each_member(
        what, [&](const std::string& key, const DocumentValue& place, const DocumentValue& v) {
          const auto at = std::find(known.begin(), known.end(), key);
          if (at == known.end())
            place.fail("unknown key \"" + key + "\" in " + std::string(what) + "; it takes " +
                       list(known));
          if (find(key)) place.fail("key \"" + key + "\" stands twice in " + std::string(what));
          members_[used_++] = {*at, v};
        });
  }

  std::optional<DocumentValue> find(std::string_view key) const {
    for (std::size_t i = 0; i < used_; ++i)
      if (members_[i]->first == key) return members_[i]->second;
    return std::nullopt;
  }

  DocumentValue get(std::string_view key) const {
    const std::optional<DocumentValue> value = find(key);
    if (!value) value_.fail("key \"" + std::string(key) + "\" is missing in " + std::string(what_));
    return *value;
  }

  /// The members' places in the text, in their order.
  template <class F>
  void for_each(F&& f) const {
    for (std::size_t i = 0; i < used_; ++i) f(members_[i]->first, members_[i]->second);
  }

 private:
  static std::string list(std::initializer_list<std::string_view> known) {
    std::string text;
    for (const std::string_view key : known) text += (text.empty() ? "" : ", ") + std::string(key);
    return text;
  }

  DocumentValue value_;
  std::string_view what_;
  std::array<std::optional<std::pair<std::string_view, DocumentValue>>, 12> members_;
  std::size_t used_ = 0;
};

}  // namespace cigsim
