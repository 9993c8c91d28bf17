"""Pictures as PNG files, drawn without a screen."""

import io

import matplotlib

matplotlib.use("Agg")

from matplotlib import pyplot  # noqa: E402


def png(figure: pyplot.Figure) -> bytes:
    """Closes the figure. Equal figures give equal bytes."""
    figure.tight_layout()
    data = io.BytesIO()
    figure.savefig(data, format="png", dpi=110, metadata={"Software": None})
    pyplot.close(figure)
    return data.getvalue()
