"""Pictures as PNG files, drawn without a screen."""

import io
import warnings

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams["text.parse_math"] = False   # names may have $ in them

from matplotlib import pyplot  # noqa: E402


def png(figure: pyplot.Figure, top: float = 1.0) -> bytes:
    """Encodes and closes the figure. Equal figures give equal bytes. @param top upper end of the axes, as a fraction of the height;
    titles are above"""
    data = io.BytesIO()
    with warnings.catch_warnings():   # missing glyphs, labels that need much space
        warnings.simplefilter("ignore")
        figure.tight_layout(rect=(0, 0, 1, top))
        figure.savefig(data, format="png", dpi=110, metadata={"Software": None})
    pyplot.close(figure)
    return data.getvalue()
