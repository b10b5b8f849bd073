#!/usr/bin/env bash
# Runs in a bare Debian 12 with the packages in /srv/packages: each step is a function of a file beside this one.
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 HOME=/root
share=/usr/share/opal
demo=$share/maps/malaga/malaga-demo
plugins=$(echo /usr/lib/*-linux-gnu)/opal/plugins
source "$here/use.sh"
source "$here/develop.sh"
source "$here/remove.sh"

install() { apt-get install -y -q --no-install-recommends "$@" </dev/null; }

expect() {  # WHAT COMMAND...
  local what=$1
  shift
  "$@" || { echo "$what: '$*' failed"; exit 1; }
}

# A step runs in a shell of its own, which ends at its first failure. Lines that begin with "= " are shown, after the seconds that
# went by and those of the processor.
run_steps() {  # STEP...
  local step TIMEFORMAT='%0R %0U %0S' wall user system
  for step in "$@"; do
    if ! { time bash "$here/steps.sh" "$step" >/srv/step.log 2>&1; } 2>/srv/step.time; then
      tail -n 60 /srv/step.log
      echo "FAILED: ${step//_/ }"
      exit 1
    fi
    read -r wall user system </srv/step.time
    printf '%-36s %4d s, CPU %3d s  %s\n' "${step//_/ }" "$wall" $((user + system)) \
      "$(sed -n 's/^= //p' /srv/step.log | paste -sd ';' | sed 's/;/; /g')"
  done
}

if [ $# -eq 1 ]; then
  "$1"
else
  run_steps add_the_packages_to_apt remember_the_bare_system \
    install_the_program say_the_version run_the_demo ignore_folders_of_the_machine \
    install_every_plugin keep_every_contract read_the_example_deployment look_for_robots install_python find_a_pose_in_python \
    run_a_scorer_in_python list_the_bill_of_materials purge_everything find_nothing_left \
    install_for_developers build_a_plugin_with_cmake build_a_plugin_with_pkg_config embed_the_localizer \
    read_the_manual complete_commands check_the_service install_the_pages purge_everything find_no_file_of_opal
  echo "the packages work on a bare Debian 12, and leave nothing behind"
fi
