# values.awk: the figures of a CSV file as TeX definitions, \setvalue{PREFIX/KEY.../COLUMN}{FIGURE},
# and each number a hundredfold as PREFIX/KEY.../COLUMN/percent.
#   awk -v prefix=irreg -v keys=3 -f values.awk points.csv
# The first `keys` columns tell the lines apart.
function escaped(text) {
  gsub(/^"|"$/, "", text)
  gsub(/""/, "\"", text)
  gsub(/[&%_#]/, "\\\\&", text)
  return text
}
function set(name, text) { printf "\\setvalue{%s}{%s}\n", name, text }
BEGIN { FS = "," }
NR == 1 {
  for (i = 1; i <= NF; ++i) column[i] = $i
  next
}
column[2] == "value" && column[1] == "key" {
  text = substr($0, length($1) + 2)
  if ($1 == "warning") $1 = "warning" ++warnings
  set(prefix "/" $1, escaped(text))
  next
}
{
  name = prefix
  for (i = 1; i <= keys; ++i) name = name "/" $i
  for (i = keys + 1; i <= NF; ++i) {
    set(name "/" column[i], escaped($i))
    if ($i ~ /^-?[0-9.]+(e[-+]?[0-9]+)?$/) set(name "/" column[i] "/percent", 100 * $i)
  }
}
