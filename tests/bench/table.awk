# From rows of the packed bench to a table of medians, ratios to the peers, and growth exponents in the number of floes.
NR > 1 {
  key = $1 SUBSEP $2 SUBSEP $3
  n[key]++
  for (k = 4; k <= 9; k++) v[key, k, n[key]] = $k
  floes[$1 SUBSEP $3 SUBSEP $2] = 1
}
function median(key, k,    i, j, x, t, m) {
  m = n[key]
  for (i = 1; i <= m; i++) x[i] = v[key, k, i]
  for (i = 2; i <= m; i++) for (j = i; j > 1 && x[j - 1] > x[j]; j--) { t = x[j]; x[j] = x[j - 1]; x[j - 1] = t }
  return x[int((m + 1) / 2)]
}
END {
  split("200 1000 4000", N, " "); split("10 50 200", S, " "); split("nilas bullet ode", E, " ")
  printf "%6s %6s %-7s %9s %9s %9s %9s %9s %7s\n", "floes", "sweeps", "engine", "detect", "solve", "water", "total ms", "contacts", "pen/h"
  for (a = 1; a <= 3; a++) for (b = 1; b <= 3; b++) {
    for (e = 1; e <= 3; e++) {
      key = E[e] SUBSEP N[a] SUBSEP S[b]
      if (!(key in n)) for (k in n) { split(k, part, SUBSEP); if (part[1] == E[e] && part[3] == S[b] && part[2] > 0.8 * N[a] && part[2] < 1.2 * N[a]) key = k }
      if (!(key in n)) continue
      total[E[e], N[a], S[b]] = median(key, 7)
      printf "%6s %6s %-7s %9.3f %9.3f %9.3f %9.3f %9.0f %7.3f\n", N[a], S[b], E[e], median(key, 4), median(key, 5), median(key, 6), median(key, 7), median(key, 8), median(key, 9)
    }
    if (total["bullet", N[a], S[b]] > 0 && total["ode", N[a], S[b]] > 0)
      printf "%22s nilas/bullet %.2f   nilas/ode %.2f\n", "", total["nilas", N[a], S[b]] / total["bullet", N[a], S[b]], total["nilas", N[a], S[b]] / total["ode", N[a], S[b]]
  }
  print "\ngrowth exponents of total ms in the number of floes (200 to 1000, 1000 to 4000)"
  for (b = 1; b <= 3; b++) for (e = 1; e <= 3; e++) {
    t1 = total[E[e], 200, S[b]]; t2 = total[E[e], 1000, S[b]]; t3 = total[E[e], 4000, S[b]]
    if (t1 > 0 && t2 > 0 && t3 > 0) printf "%6s sweeps %-7s %.2f %.2f\n", S[b], E[e], log(t2 / t1) / log(5), log(t3 / t2) / log(4)
  }
}
