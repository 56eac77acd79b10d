#pragma once
/// What the functions of run_kernels.h do, for the namespace that `solvers` stands for where this is included.
namespace nilas::solvers {

inline void append(const VecX& numbers, std::vector<double>& results) {
  results.insert(results.end(), numbers.begin(), numbers.end());
}

/// Products of 3 x 3 blocks, as in the factorisations of W.
inline void append_products(std::vector<double>& results) {
  constexpr int k_blocks = 5;
  std::vector<PaddedBlock> blocks, row(k_blocks);
  std::vector<int> columns;
  for (int k = 0; k < k_blocks; ++k) {
    Mat3 m;
    for (int i = 0; i < 9; ++i) m.data()[i] = std::sin(1.0 + i + 9 * k);
    blocks.emplace_back(m);
    columns.push_back(k_blocks - 1 - k);
  }
  subtract_products(product(blocks[0], blocks[1]), blocks.data(), columns.data(), blocks.size(), row.data());
  for (const PaddedBlock& block : row)
    for (const auto& column : block.column) results.insert(results.end(), column, column + 4);
}

/// Iterates of the interior point with each shift: products and factors of both kinds on the bodies, and the algebra
/// of cones. Rounding multiplies in them, so that a last bit that differs anywhere shows.
inline std::vector<double> run_kernels(const contact::ContactProblem& problem) {
  const contact::PreparedProblem prepared(problem);
  const BodyIsland bodies(prepared);
  const NodePlan plan = plan_nodes(bodies).value();
  InteriorOnBodies interior(prepared, bodies, plan);
  const VecX nothing = VecX::Zero(3 * problem.num_contacts());
  std::vector<double> results;
  for (const InteriorSettings& settings : {InteriorSettings{}, InteriorSettings{Shift::differentiated, 0.7, 1, 20},
                                           InteriorSettings{Shift::held, 0, 1, 12}}) {
    const auto found = interior.run(nothing, 1e-9, Budget({.max_iterations = 15}), settings);
    append(found.r, results);
    results.push_back(found.law_map_m_s);
    results.push_back(found.iterations);
  }
  append_products(results);
  return results;
}

}  // namespace nilas::solvers
