# Sourced by drivers/harmos and .ci/run: installs what a list of Debian packages names and the system lacks.

say() { echo "harmos: $*" >&2; }
fail() { say "$*"; exit 1; }

# The names in a list with comments that are not installed.
missing_packages() {
  local wanted installed
  wanted=$(sed 's/#.*//' "$1" | tr -s ' ' '\n' | sed '/^$/d' | sort)
  installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' $wanted 2>/dev/null | sed -n 's/ installed$//p' | sort -u || true)
  comm -23 <(echo "$wanted") <(echo "$installed")
}

# install_missing LIST LOG
install_missing() {
  if ! command -v dpkg-query >/dev/null; then
    return  # not Debian: CMake names what it does not find
  fi
  local list=$1 log=$2 missing as_root=()
  missing=$(missing_packages "$list")
  if [ -z "$missing" ]; then
    return
  fi
  say "these Debian packages are missing ($list says what each is for):"
  sed 's/^/  /' <<<"$missing" >&2
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || fail "neither root nor sudo: ask an administrator to run
  apt-get install --no-install-recommends $(echo $missing)"
    as_root=(sudo)
    [ -t 0 ] || as_root=(sudo -n)
  fi
  say "installing them with ${as_root[*]:+${as_root[*]} }apt-get, this takes a few minutes once"
  mkdir -p "$(dirname "$log")"
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0)
  if ! { "${apt[@]}" update && "${apt[@]}" install -y --no-install-recommends $missing; } </dev/null >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    fail "apt-get failed (no network, no rights, or not Debian 12?). By hand:
  apt-get install --no-install-recommends $(echo $missing)"
  fi
}
