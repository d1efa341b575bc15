"""Prints Google Benchmark's JSON as a table of medians and ratios: bench-table.py bench.json"""

import json
import sys


def medians(path):
    """Name of each benchmark -> median real time [s]."""
    scale = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
    with open(path) as file:
        runs = json.load(file)["benchmarks"]
    aggregated = any(run.get("aggregate_name") == "median" for run in runs)
    return {
        run["run_name"].removesuffix("/real_time"): run["real_time"] * scale[run["time_unit"]]
        for run in runs
        if not aggregated or run.get("aggregate_name") == "median"
    }


def readable(seconds):
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:.2f} {unit}"
    return f"{seconds * 1e9:.0f} ns"


def main(path):
    times = medians(path)
    print("| job | library | median | leitstand's ratio to it |")
    print("|---|---|---|---|")
    for name, seconds in sorted(times.items()):
        job, _, library = name.partition("/")
        ours = times.get(f"{job}/leitstand")
        ratio = f"{ours / seconds:.3f}" if ours and library != "leitstand" else ""
        print(f"| {job} | {library} | {readable(seconds)} | {ratio} |")
    for single, double in (("icp_iteration", "icp_2threads"), ("gicp", "gicp_2threads")):
        one, two = times.get(f"{single}/leitstand"), times.get(f"{double}/leitstand")
        if one and two:
            print(f"\n{single}: two threads are {one / two:.2f} times one")


if __name__ == "__main__":
    main(sys.argv[1])
