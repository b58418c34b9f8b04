// SPDX-License-Identifier: MIT
#include "models/priority_processor/so_golden.hpp"

#include <bit>
#include <stdexcept>

namespace cigsim::priority_processor {
namespace {

constexpr unsigned kTogether = 4;  // planes of one lookup
constexpr unsigned kChoices = 1u << kTogether;

/// Rows become columns: bit c of word r goes to bit r of word c. Swaps ever smaller squares
/// (Warren, Hacker's Delight, sec. 7-3).
void transpose(std::array<std::uint64_t, 64>& block) {
  std::uint64_t mask = 0x00000000ffffffffu;
  for (unsigned size = 32; size != 0; size >>= 1, mask ^= mask << size) {
    for (unsigned r = 0; r < 64; r = ((r | size) + 1) & ~size) {
      const std::uint64_t swapped = ((block[r] >> size) ^ block[r | size]) & mask;
      block[r | size] ^= swapped;
      block[r] ^= swapped << size;
    }
  }
}

/// `word_of(row, word)` is a word of a row; the columns are written over.
template <class WordOf>
void make_columns(unsigned objects, unsigned planes, WordOf word_of, std::vector<SoBits>& columns) {
  std::array<std::uint64_t, 64> block;
  for (unsigned row_word = 0; row_word * 64 < objects; ++row_word) {
    for (unsigned column_word = 0; column_word * 64 < planes; ++column_word) {
      for (unsigned r = 0; r < 64; ++r)
        block[r] = row_word * 64 + r < objects ? word_of(row_word * 64 + r, column_word) : 0;
      transpose(block);
      for (unsigned c = 0; c < 64 && column_word * 64 + c < planes; ++c)
        columns[column_word * 64 + c][row_word] = block[c];
    }
  }
}

}  // namespace

SoGolden::SoGolden(unsigned objects, unsigned planes) : objects_(objects), planes_(planes) {
  if (objects < 1 || objects > kSoMost || planes < 1 || planes > kSoMost)
    throw std::invalid_argument("the SO matrix has 1 to 256 objects and planes");
  rows_.resize(objects);
  plus_columns_.resize(planes);
  minus_columns_.resize(planes);
  for (unsigned n = 0; n < planes; ++n) plane_mask_[n / 64] |= std::uint64_t{1} << n % 64;
  const unsigned words = (objects + 63) / 64;
  near_.resize(std::size_t{(planes + 63) / 64} * 64 / kTogether * kChoices * words);
  beyond_.resize(near_.size());
  switch (words) {
    case 1:
      build_ = &SoGolden::build_unions<1>, row_ = &SoGolden::row_of<1>;
      break;
    case 2:
      build_ = &SoGolden::build_unions<2>, row_ = &SoGolden::row_of<2>;
      break;
    case 3:
      build_ = &SoGolden::build_unions<3>, row_ = &SoGolden::row_of<3>;
      break;
    default:
      build_ = &SoGolden::build_unions<4>, row_ = &SoGolden::row_of<4>;
  }
}

void SoGolden::set_row(unsigned object, const SoRow& row) {
  for (std::size_t w = 0; w < plane_mask_.size(); ++w) {
    rows_[object].tells[w] = row.tells[w] & plane_mask_[w];
    rows_[object].plus[w] = row.plus[w];
  }
  columns_stand_ = false;
}

void SoGolden::mark(const SoBits& eye, const SoBits& active) {
  eye_ = eye;
  active_ = active;
  if (!columns_stand_) {
    make_columns(
        objects_, planes_,
        [&](unsigned r, unsigned w) { return rows_[r].tells[w] & rows_[r].plus[w]; },
        plus_columns_);
    make_columns(
        objects_, planes_,
        [&](unsigned r, unsigned w) { return rows_[r].tells[w] & ~rows_[r].plus[w]; },
        minus_columns_);
    columns_stand_ = true;
  }
  (this->*build_)();
}

template <unsigned Words>
void SoGolden::build_unions() {
  for (unsigned first = 0; first < planes_; first += kTogether) {
    std::uint64_t* const near = &near_[std::size_t{first} / kTogether * kChoices * Words];
    std::uint64_t* const beyond = &beyond_[std::size_t{first} / kTogether * kChoices * Words];
    for (unsigned n = first; n < first + kTogether && n < planes_; ++n) {
      const bool on_plus = eye_[n / 64] >> n % 64 & 1;
      const SoBits& near_column = on_plus ? plus_columns_[n] : minus_columns_[n];
      const SoBits& beyond_column = on_plus ? minus_columns_[n] : plus_columns_[n];
      const unsigned bit = 1u << (n - first);
      for (unsigned choice = 0; choice < bit; ++choice) {
        for (unsigned w = 0; w < Words; ++w) {
          near[(bit | choice) * Words + w] = near[choice * Words + w] | near_column[w];
          beyond[(bit | choice) * Words + w] = beyond[choice * Words + w] | beyond_column[w];
        }
      }
    }
  }
}

template <unsigned Words>
const SoAnswers& SoGolden::row_of(unsigned object) {
  std::array<std::uint64_t, Words> hides{}, hidden{};
  const SoRow& row = rows_[object];
  const std::uint64_t *near = near_.data(), *beyond = beyond_.data();
  for (unsigned word = 0; word * 64 < planes_; ++word) {
    const std::uint64_t other_side = row.plus[word] ^ eye_[word];
    std::uint64_t is_near = row.tells[word] & ~other_side;
    std::uint64_t is_beyond = row.tells[word] & other_side;
    for (unsigned n = 0; n < 64; n += kTogether) {
      for (unsigned w = 0; w < Words; ++w) {
        hides[w] |= beyond[is_near % kChoices * Words + w];
        hidden[w] |= near[is_beyond % kChoices * Words + w];
      }
      is_near /= kChoices;
      is_beyond /= kChoices;
      near += kChoices * Words;
      beyond += kChoices * Words;
    }
  }
  const bool active = active_[object / 64] >> object % 64 & 1;
  answers_.count = 0;
  for (unsigned w = 0; w < Words; ++w) {
    const std::uint64_t self = w == object / 64 ? std::uint64_t{1} << object % 64 : 0;
    const std::uint64_t asked = active ? active_[w] & ~self : 0;
    answers_.hides[w] = hides[w] & ~hidden[w] & asked;
    answers_.hidden[w] = hidden[w] & ~hides[w] & asked;
    answers_.unresolved[w] = ~(hides[w] | hidden[w]) & asked;
    answers_.count += static_cast<unsigned>(std::popcount(answers_.hidden[w]));
  }
  return answers_;
}

}  // namespace cigsim::priority_processor
