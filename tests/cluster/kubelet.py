"""kubelet.py MANIFEST: does what Kubernetes does with the Jobs of a manifest, as far
as their containers' commands and their policies go, with this machine in the image's place: an index
whose pod ends with a status that FailIndex names has failed, another is tried again up to
backoffLimitPerIndex times. Prints what it tried again; ends with 1 where an index or a Job failed."""

import os
import subprocess
import sys

import yaml


def run_pod(spec, more):
    container = spec["containers"][0]
    env = {"PATH": os.environ["PATH"], **{each["name"]: each["value"] for each in container["env"]}, **more}
    command = container["command"]
    return subprocess.run(
        command, env=env, cwd=container["workingDir"], stdout=subprocess.DEVNULL, check=False).returncode


def run_index(job, index):
    policy = job["podFailurePolicy"]["rules"]
    final = [value for rule in policy if rule["action"] == "FailIndex" for value in rule["onExitCodes"]["values"]]
    for attempt in range(job["backoffLimitPerIndex"] + 1):
        status = run_pod(job["template"]["spec"], {"JOB_COMPLETION_INDEX": str(index)})
        if status == 0:
            return True
        print(f"index {index}, attempt {attempt}: status {status}", flush=True)
        if status in final:
            return False
    return False


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        shares, finish = (document["spec"] for document in yaml.safe_load_all(file))
    indices = range(shares["completions"])
    # All of them, also where one has failed.
    if not all([run_index(shares, index) for index in indices]):
        return 1
    return 0 if run_pod(finish["template"]["spec"], {}) == 0 else 1


sys.exit(main())
