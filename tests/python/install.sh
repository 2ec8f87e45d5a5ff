#!/usr/bin/env bash
# Installs the Python package with pip and imports it. From a copy: pip builds among the sources.
#
#   install.sh PACKAGE_DIR WORK_DIR VERSION
set -euo pipefail

package_dir=$1 work_dir=$2 version=$3
rm -rf "$work_dir"
mkdir -p "$work_dir/source"
cp -r "$package_dir/pyproject.toml" "$package_dir/harmos" "$work_dir/source"
/usr/bin/python3 -m pip install --quiet --disable-pip-version-check --root-user-action=ignore --no-index \
  --no-build-isolation --no-deps --target "$work_dir/site" "$work_dir/source"
cd "$work_dir"
test -f site/harmos/py.typed
found=$(PYTHONPATH=$work_dir/site /usr/bin/python3 -c '
import importlib.metadata
import harmos.program, harmos.report.page
print(importlib.metadata.version("harmos"), harmos.__file__)')
[ "$found" = "$version $work_dir/site/harmos/__init__.py" ] || { echo "found $found, not version $version"; exit 1; }
