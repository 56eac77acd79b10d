#!/bin/bash
# Runs a study through a real Slurm of one node, and compares its tables with those of a local run.
#
# usage: tests/slurm/single-node.sh [STUDY.yaml]
#
# It needs root, Debian's packages slurm-wlm and munge, and Snakemake 8 or newer with its plugin for
# Slurm. NILAS_SNAKEMAKE names that program; without it a virtual environment is made. KEEP=1
# leaves its files. A machine that has a Slurm of its own is left alone. All daemons that it starts
# end with it, and the links in /etc/slurm are removed. It is not part of CI, which has no root.
#
# Exit code 0: both tables are equal. 77: this machine cannot run it, and why is told.
set -euo pipefail

here=$(cd "$(dirname "$0")/../.." && pwd)
study=$(realpath "${1:-$here/tests/slurm/study.yaml}")
work=$(mktemp -d /tmp/nilas-slurm.XXXXXX)
daemons=()

skip() { echo "skipped: $*" >&2; exit 77; }

stop() {
  for pid in "${daemons[@]}"; do kill "$pid" 2>/dev/null || true; done
  wait 2>/dev/null || true
  for file in slurm.conf cgroup.conf; do
    [ "$(readlink /etc/slurm/$file)" = "$work/$file" ] && rm "/etc/slurm/$file"
  done
  [ -n "${KEEP:-}" ] && echo "files: $work" || rm -rf "$work"
}
trap stop EXIT

install() {
  [ "$(id -u)" = 0 ] || skip "Slurm's daemons need root."
  for tool in slurmctld slurmd munged sbatch; do
    command -v "$tool" >/dev/null && continue
    apt-get install -y -q slurm-wlm munge >"$work/apt.log" 2>&1 || skip "apt cannot install slurm-wlm and munge."
  done
  if [ -z "${NILAS_SNAKEMAKE:-}" ]; then
    /usr/bin/python3 -m venv "$work/venv"
    "$work/venv/bin/pip" -q install 'snakemake>=8' snakemake-executor-plugin-slurm ||
      skip "pip cannot install Snakemake and its plugin for Slurm."
    NILAS_SNAKEMAKE=$work/venv/bin/snakemake
  fi
}

# Jobs are followed by their process trees: control groups are often not free in a container.
configure() {
  mkdir -p "$work/state" "$work/spool"
  chown -R slurm: "$work/state"
  chmod 755 "$work"
  local memory
  memory=$(awk '/MemTotal/ {print int($2 / 1024 * 0.8)}' /proc/meminfo)
  cat >"$work/slurm.conf" <<CONF
ClusterName=nilas
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmctldPort=16817
SlurmdPort=16818
SlurmUser=slurm
AuthType=auth/munge
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/state/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SchedulerType=sched/backfill
SchedulerParameters=batch_sched_delay=0,sched_interval=2
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
MinJobAge=600
ReturnToService=2
NodeName=$(hostname -s) NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=$memory State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
  printf 'CgroupAutomount=no\n' >"$work/cgroup.conf"
  # Steps of a job look for the configuration at its usual place.
  mkdir -p /etc/slurm
  for file in slurm.conf cgroup.conf; do
    [ ! -e "/etc/slurm/$file" ] || skip "/etc/slurm/$file is there already: this machine has a Slurm of its own."
    ln -s "$work/$file" "/etc/slurm/$file"
  done
}

start() {
  if ! munge -n >/dev/null 2>&1; then
    mkdir -p /run/munge && chown munge: /run/munge
    runuser -u munge -- munged --foreground >"$work/munged.log" 2>&1 &
    daemons+=($!)
  fi
  for _ in $(seq 50); do munge -n >/dev/null 2>&1 && break; sleep 0.2; done
  munge -n >/dev/null 2>&1 || { cat "$work/munged.log"; skip "munged does not start."; }
  slurmctld -D >"$work/slurmctld.log" 2>&1 &
  daemons+=($!)
  slurmd -D -N "$(hostname -s)" >"$work/slurmd.log" 2>&1 &
  daemons+=($!)
  for _ in $(seq 100); do
    sinfo -h -o %T 2>/dev/null | grep -q idle && return
    sleep 0.3
  done
  tail -5 "$work/slurmctld.log" "$work/slurmd.log" >&2
  skip "Slurm's node does not come up."
}

main() {
  install
  configure
  start
  export PYTHONPATH=$here/python
  local nilas=(/usr/bin/python3 -m nilas.study "$study")
  cd "$work"
  # Exit code 3: runs of the study fail, as they shall on both ways.
  "${nilas[@]}" --out "$work/local" -j "$(nproc)" --quiet || [ $? = 3 ]
  "${nilas[@]}" --out "$work/slurm" --snakemake
  "$NILAS_SNAKEMAKE" -s "$work/slurm/Snakefile" --executor slurm --jobs 20 --slurm-no-account \
    --slurm-status-command squeue --seconds-between-status-checks 2 --slurm-init-seconds-before-status-checks 2 \
    --latency-wait 20 --keep-going >"$work/snakemake.log" 2>&1 || grep "runs failed" "$work/snakemake.log"
  echo "$(grep -c '_job_complete.*done' "$work/slurmctld.log") jobs were completed by Slurm."
  cmp "$work/local/study.csv" "$work/slurm/study.csv"
  cmp "$work/local/points.csv" "$work/slurm/points.csv"
  echo "The tables of Slurm and of the local run are the same to the last digit."
}

main
