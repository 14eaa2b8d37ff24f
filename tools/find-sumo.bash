# SPDX-License-Identifier: Apache-2.0
# Sourced by tools/networks and tools/scenarios with $root set: exports SUMO_HOME, puts SUMO's programs first in
# PATH, sets $python and $sumo_version. SUMO is looked for in $SUMO_HOME, the project's .venv, Debian's folder.
# shellcheck shell=bash

find_sumo() {
    local home
    for home in "${SUMO_HOME:-}" "$root"/.venv/lib/python3*/site-packages/sumo /usr/share/sumo; do
        if [[ -n $home && -f $home/tools/randomTrips.py ]]; then
            SUMO_HOME=$(cd "$home" && pwd)
            export SUMO_HOME
            export PATH="$SUMO_HOME/bin:$PATH"
            python=python3
            [[ -x $root/.venv/bin/python ]] && python=$root/.venv/bin/python
            sumo_version=$(netgenerate --version | sed -n '1s/.* //p')
            return
        fi
    done
    echo "Error: SUMO was not found; set SUMO_HOME or run tools/setup." >&2
    exit 1
}

# Reads a generated XML file from standard input and replaces the header comment, which names the time and the
# folders of this machine, by one that is the same everywhere. $1: what made it.
clean_header() {
    sed -e '/^<!-- generated on/,/-->/d' -e '/^$/d' |
        sed -e "1a <!-- SPDX-License-Identifier: Apache-2.0 -->\\
<!-- made by $1, SUMO $sumo_version -->"
}
