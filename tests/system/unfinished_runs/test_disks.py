"""Disks that are full or cannot be written."""

import contextlib
import fcntl
import os
import resource
import shutil
import signal
import struct
import subprocess

from runs import CONFIG, CORRIDOR, MALAGA, PATIENCE_S, RunTest, program

LOCALIZE = ["localize", CONFIG, CORRIDOR + ".log.gz", "--map", CORRIDOR + ".map.yaml", "-o"]
IMPORT = ["map", "import", CORRIDOR + ".map.yaml", "-o"]


class Disk(RunTest):
    @contextlib.contextmanager
    def mounted(self, options):
        disk = self.folder / "disk"
        disk.mkdir()
        made = subprocess.run(["mount", "-t", "tmpfs", "-o", options, "opal-test", str(disk)], capture_output=True, text=True)
        if made.returncode != 0:
            self.skipTest("no right to mount a file system: " + made.stderr.strip())
        try:
            yield disk
        finally:
            subprocess.run(["umount", str(disk)], check=True)

    def test_a_full_disk_is_named_and_leaves_whole_events_and_a_mark(self):
        with self.mounted("size=256k"):
            said = self.run_to_its_end(*LOCALIZE, "disk/out", expected=4)
            self.assertIn("cannot be written: No space left on device", said.stderr)
            self.assertIn("disk/out/", said.stderr)
            self.events("disk/out")
            self.assertIsNotNone(self.marker("disk/out"))
            names = {file.name for file in (self.folder / "disk" / "out").iterdir()}
            self.assertFalse([name for name in names if name.endswith(".part")])
            self.assertIn("this run was not finished", self.run_to_its_end("explain", "disk/out").stderr)

    def test_a_disk_that_is_full_from_the_start_takes_nothing(self):
        with self.mounted("size=64k") as disk:
            with contextlib.suppress(OSError), open(disk / "filler", "wb", buffering=0) as filler:
                while True:
                    filler.write(b"x" * 4096)
            said = self.run_to_its_end(*LOCALIZE, "disk", expected=4)
            self.assertIn("disk/unfinished.json: cannot be written: No space left on device", said.stderr)
            self.assertEqual([file.name for file in disk.iterdir()], ["filler"])

    def test_a_map_that_does_not_fit_leaves_the_map_that_was_there(self):
        with self.mounted("size=64k") as disk:
            (disk / "map.jsonld").write_text("the old one\n")
            with open(disk / "filler", "wb") as filler:
                filler.write(b"x" * 40000)
            said = self.run_to_its_end(*IMPORT, "disk/map.jsonld", expected=4)
            self.assertIn("disk/map.jsonld: cannot be written: No space left on device", said.stderr)
            self.assertEqual((disk / "map.jsonld").read_text(), "the old one\n")
            self.assertEqual({file.name for file in disk.iterdir()}, {"map.jsonld", "filler"})

    def test_a_simulation_that_does_not_fit_leaves_no_half_log(self):
        with self.mounted("size=64k") as disk:
            said = self.run_to_its_end("simulate", CORRIDOR + ".map.yaml", "-o", "disk/sim", expected=4)
            self.assertIn("disk/sim.log.gz: cannot be written: No space left on device", said.stderr)
            self.assertEqual(list(disk.iterdir()), [])

    def test_a_read_only_disk_is_named(self):
        with self.mounted("ro"):
            said = self.run_to_its_end(*LOCALIZE, "disk/out", expected=4)
            self.assertIn("disk/out: the folder cannot be made: Read-only file system", said.stderr)
            said = self.run_to_its_end(*IMPORT, "disk/map.jsonld", expected=4)
            self.assertIn("disk/map.jsonld: cannot be written: Read-only file system", said.stderr)

    def test_a_limit_on_the_size_of_files_leaves_the_file_that_was_there(self):
        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_DFL)
            resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))

        (self.folder / "map.jsonld").write_text("the old one\n")
        done = subprocess.run([program(), *IMPORT, "map.jsonld"], cwd=self.folder, capture_output=True, text=True,
                              preexec_fn=limit, timeout=PATIENCE_S)
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertIn("map.jsonld: cannot be written: File too large", done.stderr)
        self.assertEqual([file.name for file in self.folder.iterdir()], ["map.jsonld"])
        self.assertEqual((self.folder / "map.jsonld").read_text(), "the old one\n")

    def test_a_file_that_others_point_to_stays_where_it_is(self):
        (self.folder / "real.jsonld").write_text("the old one\n")
        (self.folder / "link.jsonld").symlink_to("real.jsonld")
        self.run_to_its_end(*IMPORT, "link.jsonld")
        self.assertTrue((self.folder / "link.jsonld").is_symlink())
        self.assertIn("@context", (self.folder / "real.jsonld").read_text())


class VanishedShare(RunTest):
    """A file system that answers everything with an error from some moment on, as a share does whose server has gone."""
    SHUTDOWN, WITHOUT_A_WORD = 0x8004587D, struct.pack("I", 2)  # EXT4_IOC_SHUTDOWN, EXT4_GOING_FLAGS_NOLOGFLUSH

    def setUp(self):
        super().setUp()
        if shutil.which("mkfs.ext4") is None:
            self.skipTest("mkfs.ext4 is not found (Debian: e2fsprogs)")
        self.image, self.share = self.folder / "image", self.folder / "share"
        self.share.mkdir()
        with open(self.image, "wb") as file:
            file.truncate(16 << 20)
        subprocess.run(["mkfs.ext4", "-q", str(self.image)], check=True)
        self.mount()
        self.addCleanup(self.unmount)

    def mount(self):
        made = subprocess.run(["mount", "-o", "loop", str(self.image), str(self.share)], capture_output=True, text=True)
        if made.returncode != 0:
            self.skipTest("no right to mount a file system: " + made.stderr.strip())

    def unmount(self):
        if os.path.ismount(self.share):
            subprocess.run(["umount", str(self.share)], check=True)

    def vanish(self):
        share = os.open(self.share, os.O_RDONLY)
        fcntl.ioctl(share, self.SHUTDOWN, self.WITHOUT_A_WORD)
        os.close(share)

    def come_back(self):
        self.unmount()
        self.mount()

    def test_a_run_on_a_share_that_vanishes_ends_and_says_why(self):
        process = self.start(*self.long_localize("share/out"))
        self.wait_until("it is in the middle", lambda: self.starts_of("share/out") > 3, process)
        self.vanish()
        _, errors = process.communicate(timeout=PATIENCE_S)
        self.assertEqual(process.returncode, 4, errors)
        self.assertIn("cannot be written: Input/output error", errors)
        self.assertIn("share/out/", errors)

    def test_what_was_told_as_written_is_there_when_the_share_comes_back(self):
        self.run_to_its_end(*IMPORT, "share/map.jsonld")
        written = (self.share / "map.jsonld").read_bytes()
        self.vanish()
        said = self.run_to_its_end(*IMPORT, "share/map.jsonld", expected=4)
        self.assertIn("share/map.jsonld: cannot be written: Input/output error", said.stderr)
        self.come_back()
        self.assertEqual((self.share / "map.jsonld").read_bytes(), written)

    def test_caches_on_a_share_that_has_vanished_stop_no_robot(self):
        self.vanish()
        for variable in ("OPAL_PREPARED_CACHE", "OPAL_MAP_CACHE"):
            os.environ[variable] = str(self.share / "cache")
            self.addCleanup(os.environ.pop, variable)
        self.run_to_its_end("map", "join", CORRIDOR + ".map.yaml", "--copies", "80", "-o", "large.jsonld")
        said = self.run_to_its_end("localize", CONFIG, CORRIDOR + ".log.gz", "--map", "large.jsonld", "-o", "out")
        self.assertIn("written to out", said.stdout)
