# Steps of somebody who has had enough.

files() {
  find / -xdev \( -path /proc -o -path /sys -o -path /dev -o -path /run -o -path /tmp -o -path /srv -o -path /var/cache -o -path /var/log \
    -o -path /var/lib/apt -o -path /var/lib/dpkg \) -prune -o -print | sort
}

remember_the_bare_system() { files >/srv/bare; }

purge_everything() {
  apt-get purge -y -q --auto-remove libopal0 opal-doc </dev/null
  expect "dpkg still knows packages of Opal" test -z "$(dpkg -l | awk '$2 ~ /opal/ { print $2 }')"
}

# Others leave caches and settings when they go; nothing may have the name of Opal, and no folder may be new but theirs.
find_nothing_left() {
  local left
  find_no_file_of_opal
  left=$(files | comm -13 /srv/bare - | wc -l)
  files | comm -13 /srv/bare -
  echo "= $left files of other packages stay"
}

# Files of packages that stay have the word, too: Linux has a header for a kind of disk.
find_no_file_of_opal() {
  local path left=
  while read -r path; do
    dpkg-query -S "$path" >/dev/null 2>&1 || left+=" $path"
  done < <(find / -xdev \( -path /proc -o -path /sys -o -path /srv -o -path /tmp -o -path /var/lib/apt -o -path /var/log \) -prune \
    -o -iname '*opal*' -print | grep -v '^/etc/apt/sources.list.d/opal-test.list$')
  expect "files of Opal stay:$left" test -z "$left"
}
