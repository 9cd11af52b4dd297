"""shares_on_dask.py [--scheduler ADDRESS] [--workers N] [--connect-seconds S] < shares: what
scripts/cluster/dask runs. Reads numbers of shares, a line each, and runs scripts/cluster/task for
each on a worker. A task's answer is the name of its result's folder, for a lost worker's answers are
computed again, and a share that is there takes no time."""

import argparse
import os
import shutil
import subprocess
import sys
from pathlib import Path

import dask
import distributed

ATTEMPTS_MAX = 10
VARIABLES = ("MANIFUZZ_SHARES", "MANIFUZZ_COMMAND", "MANIFUZZ_RESULTS", "PATH")


class TriedAgain(Exception):
    """The task ended by a signal."""


def run_share(task, share, variables, folder):
    """On a worker: the folder of the result, or None where it fails for good."""
    guard = shutil.which("setpriv")  # a worker that is killed must not leave the task running
    command = [guard, "--pdeathsig", "TERM", task, share] if guard else [task, share]
    done = subprocess.run(
        command, env={**os.environ, **variables}, cwd=folder, stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, errors="replace", check=False)
    if done.returncode in (0, 1):
        return str(Path(variables["MANIFUZZ_RESULTS"]) / f"share-{share}"), ""
    if done.returncode == 2:
        return None, done.stderr.strip()
    raise TriedAgain(f"share {share}: the task ended with status {done.returncode}")


def run_all(client, shares):
    task = str(Path(__file__).resolve().parent / "task")
    variables = {name: os.environ[name] for name in VARIABLES}
    # A task of a campaign uses a core, and no thread of its worker holds the others up.
    futures = client.map(
        run_share, [task] * len(shares), shares, [variables] * len(shares),
        [os.getcwd()] * len(shares), key=[f"share-{share}" for share in shares],
        retries=ATTEMPTS_MAX, pure=False)
    failed = 0
    reasons = set()
    for count, future in enumerate(distributed.as_completed(futures), 1):
        try:
            name, why = future.result()
        except (TriedAgain, distributed.scheduler.KilledWorker) as error:
            name, why = None, f"given up: {error}"
        if name is None:
            failed += 1
            if why not in reasons and len(reasons) < 5:
                print(why, file=sys.stderr)
            reasons.add(why)
        if sys.stderr.isatty():
            print(f"\r{count} of {len(shares)} shares", end="", file=sys.stderr, flush=True)
    if sys.stderr.isatty():
        print(file=sys.stderr)
    return failed


def client_of(options):
    if options.scheduler:
        return distributed.Client(options.scheduler, timeout=options.connect_seconds)
    workers = options.workers or len(os.sched_getaffinity(0))
    cluster = distributed.LocalCluster(
        n_workers=workers, threads_per_worker=1, dashboard_address=":0", silence_logs="ERROR")
    return distributed.Client(cluster)


def main():
    parser = argparse.ArgumentParser(prog="scripts/cluster/dask", add_help=False, allow_abbrev=False)
    parser.error = lambda message: sys.exit(complain(f"{message}; try scripts/cluster/dask --help"))
    parser.add_argument("--scheduler")
    parser.add_argument("--workers", type=int)
    parser.add_argument("--connect-seconds", type=float, default=30)
    options = parser.parse_args()
    if options.workers is not None and options.workers < 1:
        return complain(f"--workers: {options.workers} is not a whole number from 1 on")
    shares = sys.stdin.read().split()
    # Many workers may be lost before a share is held to be the cause.
    dask.config.set({"distributed.scheduler.allowed-failures": ATTEMPTS_MAX})
    try:
        client = client_of(options)
    except (OSError, TimeoutError, ValueError) as error:
        return complain(f"--scheduler: {options.scheduler} does not answer: {error}")
    try:
        failed = run_all(client, shares)
    finally:
        owned = client.cluster
        client.close()
        if owned is not None:
            owned.close()
    return complain(f"{failed} of {len(shares)} shares failed") if failed else 0


def complain(text):
    print(f"scripts/cluster/dask: {text}", file=sys.stderr)
    return 2


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
