# Steps of a developer: plugins and programs from outside, manual, completion, service, pages.

install_for_developers() { install libopal-dev opal-doc g++ cmake make pkg-config; }

build_a_plugin_with_cmake() {
  cd "$(mktemp -d)"
  cmake -S $share/docs/examples/outside_detector -B build -D CMAKE_BUILD_TYPE=Release -D CMAKE_INSTALL_PREFIX=/srv/acme
  cmake --build build
  ctest --test-dir build --output-on-failure
  cmake --install build
  OPAL_PLUGIN_PATH=$(dirname "$(find /srv/acme -name posts.so)") opal plugins >said
  expect "the plugin from outside is not offered" grep -q acme:PostDetector said
}

build_a_plugin_with_pkg_config() {
  cd "$(mktemp -d)"
  cp $share/docs/examples/outside_scorer/* .
  g++ -O2 -shared -fPIC -fvisibility=hidden -fvisibility-inlines-hidden scorer.cpp plugin.cpp $(pkg-config --cflags --libs opal) -Wl,--no-undefined -o likelihood_field.so
  cp plugin.jsonld likelihood_field.jsonld
  opal plugins --check likelihood_field.so
  expect "pkg-config names another folder of plugins" test "$(realpath "$(pkg-config --variable=plugindir opal)")" = "$plugins"
}

embed_the_localizer() {
  cd "$(mktemp -d)"
  cmake -S $share/docs/examples/embed -B build -D CMAKE_BUILD_TYPE=Release
  cmake --build build
  opal map import $demo.map.yaml -o map.jsonld
  build/embed $share/configs/malaga.jsonld map.jsonld $demo.log.gz >said
  expect "the embedded localizer finds no pose" grep -q '^.*localized, x ' said
}

read_the_manual() {
  local page
  install man-db
  MANWIDTH=100 man opal | cat >said
  expect "the manual does not name the commands" grep -q 'opal-localize(1)' said
  for page in $(dpkg -L opal | grep '/man1/.*gz$'); do
    expect "$page has errors" test -z "$(man --warnings=mac -l "$page" 2>&1 >/dev/null)"
  done
  expect "apropos does not find the pages" test "$(apropos -s 1 '^opal' | wc -l)" -ge 15
}

completed() {  # WORD... with the last one to complete
  COMP_WORDS=("$@")
  COMP_CWORD=$(($# - 1))
  _opal
  echo "${COMPREPLY[*]}"
}

complete_commands() {
  source /usr/share/bash-completion/completions/opal
  expect "a command is not completed" test "$(completed opal local)" = localize
  expect "a command of a command is not completed" test "$(completed opal map imp)" = import
  expect "an option is not completed" test "$(completed opal localize malaga drive.mcap --que)" = --queries
  expect "files are not left to the shell" test -z "$(completed opal localize mal)"
}

check_the_service() {
  install systemd
  systemd-analyze verify --man=no /lib/systemd/system/opal-ros2.service
  expect "the service is enabled" test -z "$(find /etc/systemd/system -name '*opal*')"
  expect "the service starts another program" grep -q '^ExecStart=/usr/bin/opal ros2 /etc/opal/robot.jsonld' /lib/systemd/system/opal-ros2.service
}

install_the_pages() {
  expect "a page is missing" test -s $share/docs/install.md
  expect "the reference is missing" test -s /usr/share/doc/opal-doc/html/index.html
  expect "a page names what is not there" test -e $share/docs/../README.md -a -e $share/docs/../configs/default.jsonld
}
