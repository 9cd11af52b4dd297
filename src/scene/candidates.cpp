#include "scene/candidates.hpp"

#include <algorithm>
#include <cassert>

namespace manifuzz::scene {
namespace {

/// For a row that has outgrown its place, or is packed.
std::uint32_t room_for(std::uint32_t count) {
  return count + count / 4 + 1;
}

}  // namespace

std::size_t Candidates::size_of(std::uint32_t first, std::uint32_t last) const {
  if (first == 0 && last == rows()) return count_;
  std::size_t size = 0;
  for (std::uint32_t a = first; a < last; ++a) size += rows_[a].count;
  return size;
}

void Candidates::add(std::uint32_t a, const Candidate& candidate) {
  if (a >= rows_.size()) {
    resize(rows_, a + 1);
    resize(filled_, a / kRowBits + 1);
  }
  if (rows_[a].count == rows_[a].room) {
    if (end_ > 3 * count_ + rows_.size()) pack();
  }
  CandidateRow& row = rows_[a];
  if (row.count == row.room) {
    const auto first = static_cast<std::uint32_t>(end_);
    const std::uint32_t room = room_for(row.count);
    end_ += room;
    assert(end_ < kNone);  // places are 32 bits: 34 GB of candidates
    resize(all_, end_ + kRowLanes);
    std::copy_n(all_.begin() + row.first, row.count, all_.begin() + first);
    row = {first, row.count, room};
  }
  all_[row.first + row.count++] = candidate;
  filled_[a / kRowBits] |= row_bit(a);
  ++count_;
  longest_row_ = std::max(longest_row_, row.count);
}

/// The rows one after another, as the bodies are.
void Candidates::pack() {
  LargeVector<Candidate> packed;
  std::size_t size = 0;
  longest_row_ = 0;
  for (const CandidateRow& row : rows_) {
    size += row.count == 0 ? 0 : room_for(row.count);
    longest_row_ = std::max(longest_row_, row.count);
  }
  make_room(packed, size + kRowLanes);
  for (CandidateRow& row : rows_) {
    const CandidateRow before = row;
    if (row.count == 0) {
      row = {};
      continue;
    }
    row = {static_cast<std::uint32_t>(packed.size()), row.count, room_for(row.count)};
    packed.insert(packed.end(), all_.begin() + before.first,
                  all_.begin() + before.first + before.count);
    packed.resize(row.first + row.room);
  }
  end_ = packed.size();
  packed.resize(end_ + kRowLanes);
  all_ = std::move(packed);
}

}  // namespace manifuzz::scene
