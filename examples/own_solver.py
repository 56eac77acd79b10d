# ---
# jupyter:
#   jupytext:
#     text_representation:
#       extension: .py
#       format_name: percent
# ---

# %% [markdown]
# # A solver of one's own
#
# We take a contact problem of a real run and solve it by twenty lines of our own, beside the solver
# of Nilas. One function judges both. This needs the compiled part of the package. Run it from the
# top of the source tree.

# %%
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import nilas

SCENE = "apps/scenes/towing.xml"
SECONDS = 3
SWEEPS = 300
FOLDER = Path("runs/examples/own-solver")

# %% [markdown]
# The scene stores the problem with the largest residual of all steps, as an FCLIB file.
# `problem.W` and `problem.q` are dense, with three rows a contact: normal, then two tangents.

# %%
if not FOLDER.exists():
    nilas.run(SCENE, out=FOLDER, until=SECONDS, settings={"output/@problems": "worst"})
problem = nilas.Problem.read(nilas.Run(FOLDER).problems[0])
print(f"{problem.num_contacts} contacts, friction from {problem.mu.min()} to {problem.mu.max()}")

# %% [markdown]
# ## The method
# Gauss-Seidel: one contact after another takes the impulse that the projection onto its cone asks
# for, while the others keep theirs. The normal velocity has `mu |u_T|` added (de Saxcé).


# %%
def onto_cone(impulse, mu):
    """The point of the Coulomb cone |r_T| <= mu r_N that is nearest to an impulse."""
    tangent = np.hypot(impulse[1], impulse[2])
    if tangent <= mu * impulse[0]:
        return impulse
    if mu * tangent <= -impulse[0]:
        return np.zeros(3)
    normal = (impulse[0] + mu * tangent) / (1 + mu**2)
    return np.array([normal, *(mu * normal / tangent * impulse[1:])])


def sweep(W, q, mu, impulses):
    """One turn over all contacts; changes the impulses, shape (contacts, 3)."""
    for k in range(len(mu)):
        rows = slice(3 * k, 3 * k + 3)
        velocity = W[rows] @ impulses.ravel() + q[k]
        velocity[0] += mu[k] * np.hypot(velocity[1], velocity[2])
        step = 1 / np.linalg.norm(W[rows, rows], 2)
        impulses[k] = onto_cone(impulses[k] - step * velocity, mu[k])


# %% [markdown]
# ## Both solvers on one problem
# `nilas.measure` computes the residuals from the impulses alone.

# %%
W, q, mu = problem.W, problem.q, problem.mu
impulses = np.zeros((problem.num_contacts, 3))
own = []
for _ in range(SWEEPS):
    sweep(W, q, mu, impulses)
    own.append(nilas.measure(problem, impulses)["law_map_m_s"])
ours = nilas.solve(problem, solver="nsgs", tolerance=1e-10, max_iterations=SWEEPS, history=True)
best = nilas.solve(problem, tolerance=1e-10)
print(f"own: {own[-1]:.2e} m/s, nsgs: {ours.residuals['law_map_m_s']:.2e} m/s")
print(f"auto: {best.residuals['law_map_m_s']:.2e} m/s after {best.iterations} iterations")
print(f"Largest difference of an impulse: {np.abs(impulses - best.impulses).max():.2e} N s")

# %%
figure, axes = plt.subplots(figsize=(7, 4.5), layout="constrained")
axes.semilogy(range(1, len(own) + 1), np.maximum(own, 1e-16), label="twenty lines of Python")
axes.semilogy(range(1, len(ours.history) + 1), np.maximum(ours.history, 1e-16), label="nsgs")
axes.set_xlabel("sweeps over all contacts")
axes.set_ylabel("residual of Coulomb's law [m/s]")
axes.set_title(f"The worst step of {SECONDS} s: {problem.num_contacts} contacts")
axes.grid(alpha=0.3)
axes.legend()
figure.savefig(FOLDER / "own-solver.png", dpi=120)
print("The picture is", FOLDER / "own-solver.png")
