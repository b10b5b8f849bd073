# Steps of a user: install, first run, plugins, Python.

add_the_packages_to_apt() {
  echo "deb [trusted=yes] file:/srv/packages ./" >/etc/apt/sources.list.d/opal-test.list
  apt-get update -q
}

packages_and_kilobytes() { echo "$(dpkg -l | grep -c ^ii) $(du -sk /usr | cut -f 1)"; }

install_the_program() {
  local packages kilobytes packages_now kilobytes_now
  read -r packages kilobytes < <(packages_and_kilobytes)
  install opal
  read -r packages_now kilobytes_now < <(packages_and_kilobytes)
  echo "= $((packages_now - packages)) packages, $(((kilobytes_now - kilobytes) / 1000)) MB"
}

say_the_version() {
  expect "the program says another version than its package" \
    test "$(opal --version)" = "opal $(dpkg-query -W -f '${Version}' opal)"
}

run_the_demo() {
  cd "$(mktemp -d)"
  local start
  start=$(date +%s.%N)
  opal demo | tee said
  echo "= $(awk -v a="$start" -v b="$(date +%s.%N)" 'BEGIN { printf "%.1f", b - a }') s, $(grep -m1 -o 'localized after [0-9.]* m' said)"
  for file in malaga.jsonld picture.png view.html; do expect "no file of the demo" test -s "opal-demo/$file"; done
}

# From /usr/bin, the folder of the sources of a build would be the root folder.
ignore_folders_of_the_machine() {
  mkdir /configs
  echo '{}' >/configs/malaga.jsonld
  cd "$(mktemp -d)"
  opal localize malaga $demo.log.gz --map $demo.map.yaml -o out
  rm -r /configs
}

install_every_plugin() {
  local type
  install opal-plugins-pcl opal-plugins-ifc opal-plugins-postgis
  opal plugins >/srv/said
  for type in PclIcpMatcher IfcImporter PostgisStore Beams GridImporter Ros1Bag Ros2Bag McapLog DxfImporter; do
    expect "the plugins of the packages do not offer it" grep -q "opal:$type" /srv/said
  done
  expect "plugins are refused" test "$(grep -ci refused /srv/said)" = 0
}

keep_every_contract() {
  opal plugins --check $plugins
  echo "= $(ls $plugins/*.so | wc -l) plugins"
}

read_the_example_deployment() {
  cd "$(mktemp -d)"
  cp /usr/share/doc/opal/examples/robot.jsonld .
  opal info $demo.log.gz --config robot.jsonld -o made.jsonld
}

# The node of ROS 2 starts and listens; nobody is there.
look_for_robots() {
  opal ros2 --check --seconds 1 --domain 77 || expect "opal ros2 --check says that a robot is missing" test $? -eq 1
}

install_python() { install python3-opal; }

find_a_pose_in_python() {
  cd "$(mktemp -d)"
  python3 - <<'PYTHON'
import opal

log = opal.read_log(opal.shipped_file("maps/malaga/malaga-demo.log.gz"))
map = opal.read_map(opal.shipped_file("maps/malaga/malaga-demo.map.yaml"))
localizer = opal.Localizer("malaga", map)
for sample in log.samples(localizer.deployment):
    estimate = localizer.update(sample)
    if estimate and estimate.is_localized:
        break
print("=", estimate)
assert estimate.is_localized
PYTHON
}

# The program starts Python by the plugin that comes with the module.
run_a_scorer_in_python() {
  cd "$(mktemp -d)"
  install opal-doc
  cp $share/docs/examples/python_scorer/likelihood.py .
  opal plugins --check likelihood.py:Likelihood
  sed 's|"opal:Beams"|"likelihood.py:Likelihood"|; s|"map": .*|"map": "'$demo.map.yaml'",|' $share/configs/malaga.jsonld >robot.jsonld
  opal localize robot.jsonld $demo.log.gz -o out
}

# Every package that Opal's packages depend on because of a library is in the bill.
list_the_bill_of_materials() {
  python3 - <<'PYTHON'
import json, subprocess

def names_in(field, package):
    told = subprocess.run(["dpkg-query", "-W", "-f", field, package], capture_output=True, text=True).stdout
    return [one.split(" ")[0].split(":")[0] for one in told.split(", ")]

bill = json.load(open("/usr/share/doc/opal/opal.spdx.json"))
assert bill["spdxVersion"] == "SPDX-2.3"
listed = {package["name"] for package in bill["packages"]}
offered = listed.union(*(names_in("${Provides}", name) for name in listed))
for own in ["opal", "libopal0", "opal-plugins", "opal-plugins-pcl", "opal-plugins-ifc", "opal-plugins-postgis", "python3-opal"]:
    for name in names_in("${Depends}", own):
        if name.startswith("lib"):
            assert name in offered, f"{own} depends on {name}, which the bill of materials does not list"
told = sum(package["licenseDeclared"] != "NOASSERTION" for package in bill["packages"])
print(f"= {len(listed)} packages, licences of {told} told, {len(bill['relationships'])} relations")
PYTHON
}
