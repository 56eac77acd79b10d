# The mean ice load along and across the course, from vessel.csv or structures.csv alone.
# Variables: h, step [s]; ramp, end of the ramp [s] or empty; course_deg, of the course, or "heading" for the vessel's
# own; body, name of a structure and an underscore, or empty; from and to [s], or empty for the window that a run takes by
# itself: from the end of the ramp or the first contact, whichever is later.
BEGIN { FS = "," }
NR == 1 {
  for (i = 1; i <= NF; ++i) column[$i] = i
  next
}
{
  t = $(column["time_s"])
  fx = $(column[body "contact_fx_N"])
  fy = $(column[body "contact_fy_N"])
  angle = (course_deg == "heading" ? $(column["yaw_deg"]) : course_deg) * atan2(0, -1) / 180
  if (begin == "" && (fx != 0 || fy != 0)) {
    begin = t - h
    if (ramp != "" && ramp > begin) begin = ramp
  }
  first = from != "" ? from : begin
  if (first == "" || t < first + h / 2 || (to != "" && t > to + h / 2)) next
  along += -(fx * cos(angle) + fy * sin(angle))
  across += -fx * sin(angle) + fy * cos(angle)
  ++n
}
END { printf "%.9g %.9g %d\n", along / n, across / n, n }
