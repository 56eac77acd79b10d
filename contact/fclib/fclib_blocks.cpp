#include "contact/fclib/fclib_blocks.h"

#include <algorithm>

#include "core/base/union_find.h"

namespace nilas::contact {

namespace {

constexpr int k_rigid_body = 6, k_point_mass = 3;  ///< degrees of freedom

using Blocks = std::vector<std::vector<int>>;

/// Gathers consecutive parts into blocks of at most `size`; larger parts stay alone.
Blocks gather(const Blocks& parts, std::size_t size) {
  Blocks blocks;
  for (const auto& part : parts) {
    if (blocks.empty() || blocks.back().size() + part.size() > size) blocks.emplace_back();
    blocks.back().insert(blocks.back().end(), part.begin(), part.end());
  }
  for (auto& block : blocks) std::sort(block.begin(), block.end());
  return blocks;
}

/// Degrees of freedom that each contact touches.
Blocks touched_by_contact(const std::vector<MatrixEntry>& jacobian, int num_contacts) {
  Blocks touched(num_contacts);
  for (const auto& entry : jacobian) touched[entry.column / 3].push_back(entry.row);
  return touched;
}

bool fits(const Blocks& blocks, int ndof, const Blocks& touched) {
  std::vector<int> block_of(ndof);
  for (std::size_t k = 0; k < blocks.size(); ++k)
    for (const int dof : blocks[k]) block_of[dof] = static_cast<int>(k);
  return std::all_of(touched.begin(), touched.end(), [&block_of](const std::vector<int>& dofs) {
    int first = -1, second = -1;
    for (const int dof : dofs) {
      const int block = block_of[dof];
      if (block == first || block == second) continue;
      if (second >= 0) return false;
      (first < 0 ? first : second) = block;
    }
    return true;
  });
}

}  // namespace

Blocks split_into_blocks(int ndof, const std::vector<MatrixEntry>& mass, const std::vector<MatrixEntry>& jacobian,
                         int num_contacts) {
  UnionFind joined(ndof);
  for (const auto& entry : mass) joined.join(entry.row, entry.column);
  const Blocks parts = joined.groups(), touched = touched_by_contact(jacobian, num_contacts);
  for (const Blocks& blocks : {parts, gather(parts, k_rigid_body), gather(parts, k_point_mass)})
    if (fits(blocks, ndof, touched)) return blocks;
  for (const auto& dofs : touched)
    for (const int dof : dofs) joined.join(dofs.front(), dof);
  return joined.groups();
}

}  // namespace nilas::contact
