"""Many runs of an experiment: batches over seeds and values, on Dask.

Programs `swarmanoid batch`, `report` and `worker`; see docs/how-to/run_a_batch.md. From the
bottom up:

    mistakes            bad input, and how programs end
    runs                one run: what is asked for, what comes of it
    run_maker           makes runs, in a process of a worker
    identity            what makes two runs of different days or computers comparable
    workers             processes that make runs: on this computer, or those of a scheduler
    dispatch            sends runs to workers, and takes what comes back
    grid, results_file, batch_command           a batch
    statistics, plots, report, report_command   its report
"""
