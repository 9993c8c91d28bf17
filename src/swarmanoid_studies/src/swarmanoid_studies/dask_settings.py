"""Settings of Dask for the programs of this package. Import this before `distributed`, which reads them on import."""

import dask

# disables unused web pages and profiles; failures of workers are reported by rows and by the program's last line
dask.config.set({"distributed.worker.profile.enabled": False, "distributed.admin.tick.limit": "1h",
                 "distributed.scheduler.http.routes": [], "distributed.worker.http.routes": [],
                 "logging": {name: "critical" for name in ("distributed", "distributed.client", "asyncio", "tornado.application")}})
