"""Many runs of an experiment, on Dask: batches over seeds and values, evolutions.

Programs `swarmanoid batch`, `report`, `worker` and `evolve`; see docs/how-to/run_a_batch.md and evolve_a_controller.md. From the
bottom up:

    mistakes            errors in input, and exit codes of programs
    input_file          files that may be damaged
    seeds               numbers and ranges
    identity            properties that must be equal for runs to be comparable
    contents            check that workers use the same files and libraries as the program
    runs                request and outcome of one run
    run_maker           makes runs
    maker_process, makers   the process that makes the runs of a worker
    workers             processes that make runs: on this computer, or those of a scheduler
    dispatch            sends runs to workers, and receives their outcomes
    atomic_file         files that are replaced atomically, and written by one program at a time
    command_options     options shared by several commands
    grid, results_file, batch_command           a batch
    results_rows, results_table                 its file, read strictly
    statistics, plots, report, report_command   its report
    study_file, optimisers, checkpoint, evolution, evolution_files, evolve_command   an evolution
    pictures            PNG output, for reports and evolutions
"""
