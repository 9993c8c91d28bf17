"""Processes that make runs: on this computer, or those of a Dask scheduler.

One thread per process: engines have process-wide state."""

import contextlib
import os
import resource
from typing import Dict, Iterator, Mapping, Optional

from . import dask_settings  # noqa: F401
from distributed import Client, LocalCluster

from .identity import identify
from .identity_fields import Identity
from .input_file import shown
from .mistakes import BadInput
from .worker_processes import WorkerProcesses

MOST_JOBS = 1024
SETUP = "swarmanoid_studies.worker_setup"
SCHEDULER_S = 10  # timeout for an answer of the scheduler [s]
FILES, FILES_A_JOB = 64, 6  # open files of this process, at most: somewhat more than observed


def default_jobs() -> int:
    return len(os.sched_getaffinity(0))


def allow_files(jobs: Optional[int]) -> int:
    """Raises this process's limit of open files to that needed for connections and pipes to the jobs.
    @param jobs None: one per processor, or as many as the system's limit permits @return number of jobs
    @raise BadInput if the system's limit is too low"""
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    most = MOST_JOBS if hard == resource.RLIM_INFINITY else (hard - FILES) // FILES_A_JOB
    count = min(default_jobs(), max(1, most)) if jobs is None else jobs
    if count > most:
        raise BadInput(f"found a limit of {hard} open files (`ulimit -Hn`), allowed: at least {FILES + FILES_A_JOB * count} for "
                       f"{count} processes that make runs")
    if soft != resource.RLIM_INFINITY:
        resource.setrlimit(resource.RLIMIT_NOFILE, (max(soft, FILES + FILES_A_JOB * count), hard))
    return count


@contextlib.contextmanager
def connected(jobs: int, scheduler: Optional[str]) -> Iterator[Client]:
    """@param jobs processes of this computer, if there is no scheduler @param scheduler its address, tcp://host:port
    @raise BadInput if the scheduler does not answer, RunsStopped if processes cannot be started"""
    if scheduler is not None:
        try:
            client = Client(scheduler, timeout=SCHEDULER_S)
        except Exception as error:  # of Dask or its transports: no answer, no certificates, unknown host
            raise BadInput(f"--scheduler: found '{scheduler}', allowed: the address of a dask-scheduler that answers "
                           f"({shown(error)})") from None
        with client:
            yield client
        return
    # security: certificates of this cluster only, since other users of the computer can reach its ports. Port 0: any port; Dask would
    # take 8787 although there is no dashboard, and other programs may use it
    with LocalCluster(n_workers=0, host="127.0.0.1", security=True, dashboard_address=None,
                      scheduler_kwargs={"dashboard_address": "127.0.0.1:0"}, silence_logs=None) as cluster:
        async def end_scheduler() -> None:
            await cluster.scheduler_comm.close_rpc()  # otherwise the cluster would try to reach it for 30 s at its end
            await cluster.scheduler.close()           # callers that wait for a result get an error

        def give_up() -> None:
            cluster.loop.add_callback(end_scheduler)

        with WorkerProcesses(jobs, cluster.scheduler_address, cluster.security, give_up) as processes:
            processes.wait_until_up()  # before a client, which would wait long for a scheduler that closes meanwhile
            with Client(cluster) as client:
                yield client


def refuse_others(client: Client, experiment: str, overrides: Mapping[str, str], own: Identity) -> None:
    """@raise BadInput if a worker of a cluster would make other runs than this computer"""
    answers: Dict[str, object] = client.run(identify, experiment, dict(overrides), on_error="return")
    for address, answer in sorted(answers.items()):
        if not isinstance(answer, Identity):
            raise BadInput(f"the worker {address} cannot read the experiment: {answer}")
        for name, here, there in zip(Identity._fields, own, answer):
            if here != there:
                raise BadInput(f"the worker {address}: {name}: found '{there}', allowed: '{here}', as here; "
                               "`swarmanoid worker` of the same build starts one that fits")
