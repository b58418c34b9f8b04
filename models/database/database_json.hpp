// SPDX-License-Identifier: MIT
// The prepared database as a JSON value, for the text file and the CBOR file alike.
//
// Whatever there is much of lies in flat arrays of numbers. A plane is five indices into a list of
// points, since its definition is made of points that it shares with its neighbours.
#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "models/database/database.hpp"

namespace cigsim {

inline constexpr const char* kDatabaseTag = "cigsim-database";
inline constexpr std::uint64_t kDatabaseVersion = 1;

/// What is wrong with a database, and where in it ("systems[0].set.faces: …").
class DatabaseFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

nlohmann::ordered_json database_to_json(const Database& database);
nlohmann::ordered_json report_to_json(const PreparationReport& report);

/// Checks types, lengths and finiteness; throws DatabaseFault. What the numbers refer to is checked
/// by check_database.
Database database_from_json(const nlohmann::json& value);

/// Throws DatabaseFault unless every index is in range, every group's planes are a binary tree over
/// its members with masks that agree, and the groups are one tree that holds each item once.
void check_database(const Database& database);

}  // namespace cigsim
