"""Many runs of an experiment, on Dask: batches over seeds and values, evolutions.

Programs `swarmanoid batch`, `report`, `worker` and `evolve`; see docs/how-to/run_a_batch.md and evolve_a_controller.md. From the
bottom up:

    mistakes            bad input, and how programs end
    input_file          files that may be damaged
    seeds               numbers and ranges
    identity            what makes two runs of different days or computers comparable
    contents            whether workers make runs of what the program has begun with
    runs                one run: what is asked for, what comes of it
    run_maker           makes runs
    maker_process, makers   the process in which a worker has them made
    workers             processes that make runs: on this computer, or those of a scheduler
    dispatch            sends runs to workers, and takes what comes back
    atomic_file         files that are there as a whole, and that one program writes at a time
    command_options     options that several commands have
    grid, results_file, batch_command           a batch
    results_rows, results_table                 its file, read strictly
    statistics, plots, report, report_command   its report
    study_file, optimisers, checkpoint, evolution, evolution_files, evolve_command   an evolution
    pictures            as PNG, for both
"""
