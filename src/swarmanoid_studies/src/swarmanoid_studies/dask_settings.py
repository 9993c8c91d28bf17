"""Settings of Dask for the programs of this package. Import this before `distributed`, which reads them as it is imported."""

import dask

# nobody looks at pages about the cluster, nor at a profile of the workers; what happens to workers is told by rows and by the
# program's last line
dask.config.set({"distributed.worker.profile.enabled": False, "distributed.admin.tick.limit": "1h",
                 "distributed.scheduler.http.routes": [], "distributed.worker.http.routes": [],
                 "logging": {name: "critical" for name in ("distributed", "distributed.client", "asyncio", "tornado.application")}})
