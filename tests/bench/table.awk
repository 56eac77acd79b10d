# From rows of the packed bench to a table of medians, ratios to the peers, and growth exponents in the number of floes.
NR > 1 {
  key = $1 SUBSEP $2 SUBSEP $3
  n[key]++
  for (k = 4; k <= 11; k++) v[key, k, n[key]] = $k
  floes[$1 SUBSEP $3 SUBSEP $2] = 1
}
function median(key, k,    i, j, x, t, m) {
  m = n[key]
  for (i = 1; i <= m; i++) x[i] = v[key, k, i]
  for (i = 2; i <= m; i++) for (j = i; j > 1 && x[j - 1] > x[j]; j--) { t = x[j]; x[j] = x[j - 1]; x[j - 1] = t }
  return x[int((m + 1) / 2)]
}
# Rows name the number of floes that were placed, the table the number asked for.
function find(engine, floes, sweeps,    k, part) {
  for (k in n) { split(k, part, SUBSEP); if (part[1] == engine && part[3] == sweeps && part[2] > 0.8 * floes && part[2] < 1.2 * floes) return k }
  return ""
}
function show(key, floes, sweeps, engine) {
  printf format, floes, sweeps, engine, median(key, 4), median(key, 5), median(key, 6), median(key, 7), median(key, 10), median(key, 8), median(key, 9), median(key, 11)
}
END {
  split("200 1000 4000", N, " "); split("10 50 200", S, " "); split("nilas bullet ode", E, " ")
  format = "%6s %6s %-10s %9.3f %9.3f %9.3f %9.3f %9.3f %9.0f %7.3f %11.2g\n"
  printf "%6s %6s %-10s %9s %9s %9s %9s %9s %9s %7s %11s\n", "floes", "sweeps", "engine", "detect", "solve", "water", "total ms", "95 %", "contacts", "pen/h", "natural m/s"
  for (a = 1; a <= 3; a++) for (b = 1; b <= 3; b++) {
    for (e = 1; e <= 3; e++) {
      key = find(E[e], N[a], S[b])
      if (key == "") continue
      total[E[e], N[a], S[b]] = median(key, 7)
      show(key, N[a], S[b], E[e])
    }
    if (total["bullet", N[a], S[b]] > 0 && total["ode", N[a], S[b]] > 0)
      printf "%22s nilas/bullet %.2f   nilas/ode %.2f\n", "", total["nilas", N[a], S[b]] / total["bullet", N[a], S[b]], total["nilas", N[a], S[b]] / total["ode", N[a], S[b]]
  }
  print "\nns per contact and sweep of the solver, from 50 to 200 sweeps"
  for (a = 1; a <= 3; a++) for (e = 1; e <= 3; e++) {
    few = find(E[e], N[a], 50); many = find(E[e], N[a], 200)
    if (few == "" || many == "") continue
    printf "%6s %-7s %.0f\n", N[a], E[e], 1e6 * (median(many, 5) - median(few, 5)) / 150 / (0.5 * (median(few, 8) + median(many, 8)))
  }
  print "\nauto on the exact cone, to 1e-6 m/s, warm-started"
  for (a = 1; a <= 3; a++) {
    key = find("nilas-auto", N[a], 0); newton = find("mujoco", N[a], 0)
    if (key != "") {
      show(key, N[a], "1e-6", "nilas-auto")
      printf "%22s over ode at 50 sweeps %.2f   95 %% over the median %.2f\n", "", median(key, 7) / total["ode", N[a], 50], median(key, 10) / median(key, 7)
    }
    cold = find("nilas-cold", N[a], 0)
    if (cold != "") {
      show(cold, N[a], "1e-6", "nilas-cold")
      printf "%22s warm start saves %.0f %% of the step\n", "", 100 * (1 - median(key, 7) / median(cold, 7))
    }
    if (newton != "") show(newton, N[a], "newton", "mujoco")
    if (key != "" && newton != "")
      printf "%22s without water nilas-auto/mujoco %.4f\n", "", (median(key, 7) - median(key, 6)) / (median(newton, 7) - median(newton, 6))
  }
  print "\ngrowth exponents of total ms in the number of floes (200 to 1000, 1000 to 4000)"
  for (b = 1; b <= 3; b++) for (e = 1; e <= 3; e++) {
    t1 = total[E[e], 200, S[b]]; t2 = total[E[e], 1000, S[b]]; t3 = total[E[e], 4000, S[b]]
    if (t1 > 0 && t2 > 0 && t3 > 0) printf "%6s sweeps %-7s %.2f %.2f\n", S[b], E[e], log(t2 / t1) / log(5), log(t3 / t2) / log(4)
  }
}
