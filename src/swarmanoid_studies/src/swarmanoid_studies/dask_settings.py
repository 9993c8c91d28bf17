"""Settings of Dask for the programs of this package. Import this before `distributed`, which reads them as it is imported."""

import dask

# the cluster's pages and profiles of workers have no readers here; rows and the program's last line report what happens to workers
dask.config.set({"distributed.worker.profile.enabled": False, "distributed.admin.tick.limit": "1h",
                 "distributed.scheduler.http.routes": [], "distributed.worker.http.routes": [],
                 "logging": {name: "critical" for name in ("distributed", "distributed.client", "asyncio", "tornado.application")}})
