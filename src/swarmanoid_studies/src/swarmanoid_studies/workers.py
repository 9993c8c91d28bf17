"""Processes that make runs: on this computer, or those of a Dask scheduler.

One thread a process: engines have state that belongs to the process."""

import contextlib
import logging
import os
from typing import Dict, Iterator, Mapping, Optional

import dask

# read when distributed is imported: nobody looks at pages about the cluster, at a profile of the workers, nor at what they log as
# they begin
dask.config.set({"distributed.worker.profile.enabled": False, "distributed.admin.tick.limit": "1h",
                 "distributed.scheduler.http.routes": [], "distributed.worker.http.routes": [],
                 "distributed.nanny.pre-spawn-environ.DASK_LOGGING__DISTRIBUTED": "critical"})

from distributed import Client, LocalCluster  # noqa: E402

from .identity import identify  # noqa: E402
from .identity_fields import Identity  # noqa: E402
from .mistakes import BadInput  # noqa: E402

MOST_JOBS = 1024
SETUP = "swarmanoid_studies.worker_setup"
SCHEDULER_S = 10  # wait for a scheduler that does not answer [s]


def default_jobs() -> int:
    return len(os.sched_getaffinity(0))


@contextlib.contextmanager
def connected(jobs: int, scheduler: Optional[str]) -> Iterator[Client]:
    """@param jobs processes of this computer, if there is no scheduler @param scheduler its address, tcp://host:port
    @raise BadInput if the scheduler does not answer"""
    # what happens to workers is told by rows and by the program's last line
    logging.getLogger("distributed").setLevel(logging.CRITICAL)
    logging.getLogger("asyncio").setLevel(logging.CRITICAL)
    if scheduler is not None:
        try:
            client = Client(scheduler, timeout=SCHEDULER_S)
        except (OSError, ValueError) as error:
            raise BadInput(f"--scheduler: found '{scheduler}', allowed: the address of a dask-scheduler that answers "
                           f"({error})") from None
        with client:
            yield client
        return
    # certificates of this cluster alone: other users of the computer can reach its ports, but not talk to it. Port 0: any, and not
    # 8787, which Dask would take though it has no dashboard, and which others may have
    with LocalCluster(n_workers=jobs, threads_per_worker=1, processes=True, host="127.0.0.1", memory_limit=0, security=True,
                      dashboard_address=None, scheduler_kwargs={"dashboard_address": "127.0.0.1:0"},
                      silence_logs=logging.CRITICAL, preload=[SETUP]) as cluster:
        with Client(cluster) as client:
            yield client


def refuse_others(client: Client, experiment: str, overrides: Mapping[str, str], own: Identity) -> None:
    """@raise BadInput if a worker of a cluster would make other runs than this computer does"""
    answers: Dict[str, object] = client.run(identify, experiment, dict(overrides), on_error="return")
    for address, answer in sorted(answers.items()):
        if not isinstance(answer, Identity):
            raise BadInput(f"the worker {address} cannot read the experiment: {answer}")
        for name, here, there in zip(Identity._fields, own, answer):
            if here != there:
                raise BadInput(f"the worker {address}: {name}: found '{there}', allowed: '{here}', as here; "
                               "`swarmanoid worker` of the same build starts one that fits")
