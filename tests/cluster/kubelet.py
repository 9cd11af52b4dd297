"""kubelet.py MANIFEST [--last-first]: does what Kubernetes does with the Jobs of a manifest, as far
as their containers' commands and their policies go, with this machine in the image's place: an index
whose pod ends with a status that FailIndex names has failed, one with a status that Ignore names comes
again behind all others, another is tried again up to backoffLimitPerIndex times. Prints what it tried
again; ends with 1 where an index or a Job failed."""

import os
import subprocess
import sys
from collections import deque

import yaml


def run_pod(spec, more):
    container = spec["containers"][0]
    env = {"PATH": os.environ["PATH"], **{each["name"]: each["value"] for each in container["env"]}, **more}
    command = container["command"]
    return subprocess.run(
        command, env=env, cwd=container["workingDir"], stdout=subprocess.DEVNULL, check=False).returncode


def statuses(job, action):
    rules = [rule for rule in job["podFailurePolicy"]["rules"] if rule["action"] == action]
    return {value for rule in rules for value in rule.get("onExitCodes", {}).get("values", [])}


def run_indices(job, indices):
    """Whether all of them end well: all run, also where one has failed."""
    final, ignored = statuses(job, "FailIndex"), statuses(job, "Ignore")
    waiting = deque((index, 0) for index in indices)
    failed = False
    while waiting:
        index, attempt = waiting.popleft()
        status = run_pod(job["template"]["spec"], {"JOB_COMPLETION_INDEX": str(index)})
        if status == 0:
            continue
        print(f"index {index}, attempt {attempt}: status {status}", flush=True)
        if status in ignored:
            waiting.append((index, attempt))
        elif status in final or attempt == job["backoffLimitPerIndex"]:
            failed = True
        else:
            waiting.appendleft((index, attempt + 1))
    return not failed


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        shares, finish = (document["spec"] for document in yaml.safe_load_all(file))
    indices = range(shares["completions"])
    if not run_indices(shares, reversed(indices) if "--last-first" in sys.argv else indices):
        return 1
    return 0 if run_pod(finish["template"]["spec"], {}) == 0 else 1


sys.exit(main())
