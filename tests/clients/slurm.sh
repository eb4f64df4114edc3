#!/usr/bin/env bash
# Slurm hands a batch out to two nodes of one core, one of which is killed in the middle and comes back: the manifest is
# that of a single run. All of it stands in a folder of its own, beside whatever Slurm the machine may have.
#   slurm.sh RAMURE-CLI FOLDER
set -euo pipefail
export RAMURE_CLI=$1
folder=$2
rows=200
rm -rf "$folder"
mkdir -p "$folder"/{state,n1,n2,trees}
cd "$folder"
folder=$PWD
me=$(id -un)
export SLURM_CONF=$folder/slurm.conf

fail() {
    echo "slurm: $*" >&2
    tail -n 5 "$folder"/*.log "$folder"/trees/slurm-*.out >&2 || true
    exit 1
}

# Waits for a command to go well: SECONDS WHAT COMMAND...
await() {
    local end=$((SECONDS + $1)) what=$2
    shift 2
    until "$@"; do
        [ $SECONDS -lt $end ] || fail "waited in vain until $what"
        sleep 0.1
    done
}

stop() {
    local name
    for name in n1 n2 slurmctld munged; do
        [ ! -s "$folder/$name.pid" ] || kill -9 "$(cat "$folder/$name.pid")" 2>/dev/null || true
    done
}
trap stop EXIT

{
    echo "preset,seed,sections.radialDivisions"
    for ((i = 1; i <= rows; i++)); do # one in twenty takes long enough to be hit
        if [ $((i % 20)) -eq 0 ]; then echo "SmallTree,$i,24"; else echo "TinyTree,$i,4"; fi
    done
} >variations.csv
files=(--file '{block}/{preset}_{seed}.obj')
"$RAMURE_CLI" batch variations.csv -o single "${files[@]}" --jobs 2
"$RAMURE_CLI" job --slurm variations.csv -o trees --shards $rows "${files[@]}"

# Others may run a farm on this machine too.
read -r port first second < <(python3 -c '
import socket
sockets = [socket.socket() for _ in range(3)]
for each in sockets: each.bind(("127.0.0.1", 0))
print(*[each.getsockname()[1] for each in sockets])')
head -c 1024 /dev/urandom >munge.key
chmod 600 munge.key
munged --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" --pid-file="$folder/munged.pid" \
    --log-file="$folder/munged.log" --seed-file="$folder/munge.seed" 2>/dev/null || fail "munged does not start"
cat >slurm.conf <<T
ClusterName=ramure
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmctldPort=$port
SlurmctldPidFile=$folder/slurmctld.pid
SlurmctldLogFile=$folder/slurmctld.log
StateSaveLocation=$folder/state
SlurmUser=$me
SlurmdUser=$me
SlurmdPidFile=$folder/%n.pid
SlurmdLogFile=$folder/%n.log
SlurmdSpoolDir=$folder/%n
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
ReturnToService=2
SlurmdTimeout=10
SchedulerParameters=sched_min_interval=100000,batch_sched_delay=0
NodeName=n1 NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=$first CPUs=1
NodeName=n2 NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=$second CPUs=1
PartitionName=all Nodes=n1,n2 Default=YES State=UP
T
slurmctld -c || fail "slurmctld does not start"
slurmd -N n1 || fail "slurmd does not start"
slurmd -N n2 || fail "slurmd does not start"
state() { [[ $(sinfo -h -N -n "$1" -o %T 2>/dev/null) =~ $2 ]]; }
await 30 "both nodes are there" state n1 '^(idle|mixed|alloc)'
await 30 "both nodes are there" state n2 '^(idle|mixed|alloc)'

begun=$SECONDS
bash trees/job.sbatch >ids
parts() { find trees -maxdepth 1 -name 'manifest-*-of-*.jsonl' | wc -l; }
in_the_middle() {
    local index
    [ "$(parts)" -ge 60 ] || return 1
    read -r lost index < <(squeue -h -w n2 -t R -o '%A %K') || return 1
    [[ $index =~ ^[0-9]+$ ]] && [ $((index % 20)) -eq 0 ]
}
await 150 "a long row is on the second node" in_the_middle
# As if the power had gone: the daemon, the one that watches the task, and the task.
kill -9 "$(cat n2.pid)"
for process in /proc/[0-9]*; do
    if grep -qs "^slurmstepd: \[$lost\." "$process/cmdline"; then kill -9 "${process#/proc/}" || true; fi
done
for process in /proc/[0-9]*; do
    if grep -qsz "^SLURM_JOB_ID=$lost\$" "$process/environ" && grep -qsz "^SLURM_CONF=$SLURM_CONF\$" "$process/environ"; then
        kill -9 "${process#/proc/}" 2>/dev/null || true
    fi
done
killed=$(parts)
await 60 "the node is known to be down" state n2 '^down'
rm -f n2.pid
slurmd -N n2 || fail "slurmd does not come back"

# A task that was lost may start after two minutes: the farm's patience, not ours.
nothing_left() {
    local id
    for id in $(squeue -h -t PD -o '%i %r' | sed -n 's/ BeginTime$//p'); do
        scontrol update JobId="$id" StartTime=now || true
    done
    [ -z "$(squeue -h)" ]
}
await 200 "all tasks have ended" nothing_left
[ -e trees/manifest.jsonl ] || fail "no manifest"
cmp single/manifest.jsonl trees/manifest.jsonl || fail "the manifest differs from that of a single run"
[ -z "$(find trees -name '.row-*')" ] || fail "half a row is left"
(cd single && find . -name '*.obj' -exec sha256sum {} + | sort) >single.sums
(cd trees && sha256sum --quiet -c ../single.sums) || fail "a tree differs"
requeued=$(grep -c -i 'requeue' slurmctld.log || true)
[ "$requeued" -gt 0 ] || fail "no task was lost"
echo "$(slurmctld -V): $rows rows in $rows tasks on 2 nodes of one core, a node killed at $killed rows," \
    "its task was requeued; the manifest is the single run's; $((SECONDS - begun)) s"
