"""The statistics against an independent implementation, Debian's python3-scipy and numpy, to 1e-6.

usage: compare_with_scipy.py STATISTICS_TOOL; exit code 77: scipy is not installed.
"""
import itertools
import json
import subprocess
import sys
import warnings

try:
    import numpy as np
    from scipy import integrate, stats
except ImportError:
    print("skipped: python3-scipy is not installed")
    sys.exit(77)

TOLERANCE = 1e-6
random = np.random.default_rng(20)
cases = []  # (request, expected, what)


def expect(what, request, expected):
    cases.append((request, np.atleast_1d(np.asarray(expected, float)), what))


def mcnemar():
    for only_a, only_b in [(0, 1), (0, 6), (1, 9), (3, 3), (5, 12), (30, 51), (120, 97), (400, 300)]:
        n = only_a + only_b
        exact = stats.binomtest(min(only_a, only_b), n).pvalue
        mid = 1 if only_a == only_b else exact - stats.binom.pmf(min(only_a, only_b), n, 0.5)
        expect("McNemar", ["mcnemar", 50, only_a, only_b, 7], [exact, mid])
        share = stats.binomtest(only_b, n).proportion_ci(0.95, "exact")
        odds = [share.low / (1 - share.low), np.inf if share.high == 1 else share.high / (1 - share.high)]
        expect("matched odds ratio", ["odds_ratio", 50, only_a, only_b, 7, 0.05], odds)
        table = np.array([50, only_a, only_b, 7]) + 0.5
        p = table / table.sum()
        d, z = p[2] - p[1], stats.norm.ppf(0.975)
        half = z * np.sqrt((p[1] + p[2] - d * d) / table.sum())
        expect("difference of shares", ["difference", 50, only_a, only_b, 7, 0.05], np.clip([d - half, d + half], -1, 1))


def enumerated(weights):
    """Two-sided p-value of a sum of signed weights, all signs equally likely."""
    signs = np.array(list(itertools.product([-1, 1], repeat=len(weights))))
    return np.mean(np.abs(signs @ np.abs(weights)) >= abs(np.sum(weights)) - 1e-9)


def wilcoxon():
    warnings.simplefilter("ignore", UserWarning)  # the normal approximation is asked for though samples are small
    for n in (1, 2, 5, 12, 25, 50):
        x = random.normal(0.4, 1, n)
        approx = stats.wilcoxon(x, mode="approx").pvalue
        expect("Wilcoxon, exact", ["wilcoxon", x.tolist()], [stats.wilcoxon(x, mode="exact").pvalue, approx])
    for n in (61, 100, 400):
        x = random.normal(0.1, 1, n)
        x[: n // 4] = 0
        x[n // 2:] = np.round(x[n // 2:], 1)
        approx = stats.wilcoxon(x, zero_method="pratt", mode="approx").pvalue
        expect("Wilcoxon, Pratt, ties", ["wilcoxon", x.tolist()], [approx, approx])
    for n in (4, 9, 14):  # with ties and zeros the exact distribution is enumerated
        x = np.round(random.normal(0.5, 1, n), 0)
        ranks = stats.rankdata(np.abs(x)) * np.sign(x)
        approx = stats.wilcoxon(x, zero_method="pratt", mode="approx").pvalue if np.any(x) else 1
        expect("Wilcoxon, exact with ties", ["wilcoxon", x.tolist()], [enumerated(ranks), approx])


def holm():
    for n in (1, 2, 7, 30):
        p = random.uniform(0, 0.2, n)
        order = np.argsort(p)
        corrected = np.empty(n)
        corrected[order] = np.minimum(1, np.maximum.accumulate((n - np.arange(n)) * p[order]))
        expect("Holm", ["holm", p.tolist()], corrected)


def bell_mccaffrey(sums, pairs):
    """Mean, standard error and degrees of freedom, by the matrices of Bell & McCaffrey (2002) for a mean: one row per pair."""
    cluster = np.repeat(np.arange(len(pairs)), pairs.astype(int))
    scores = (sums / pairs)[cluster]  # how a cluster's sum is spread over its pairs makes no difference
    n, ones = len(cluster), np.ones((len(cluster), 1))
    residual_maker = np.eye(n) - ones @ ones.T / n
    residuals, columns, variance = residual_maker @ scores, [], 0
    for i in range(len(pairs)):
        rows = cluster == i
        values, vectors = np.linalg.eigh(residual_maker[np.ix_(rows, rows)])
        adjust = vectors @ np.diag(values ** -0.5) @ vectors.T
        columns.append(residual_maker[:, rows] @ adjust @ ones[rows, 0] / n)
        variance += (ones[rows, 0] @ adjust @ residuals[rows] / n) ** 2
    eigen = np.linalg.eigvalsh(np.array(columns) @ np.array(columns).T)
    return scores.mean(), np.sqrt(variance), eigen.sum() ** 2 / (eigen ** 2).sum()


def clusters():
    for n in (2, 3, 7, 12, 40):
        sums = random.normal(1, 2, n)
        for pairs in (random.integers(3, 30 if n < 20 else 8, n).astype(float), np.full(n, 6.0)):
            mean, error, freedom = bell_mccaffrey(sums, pairs)
            expect("t between clusters", ["t_test", sums.tolist(), pairs.tolist()], 2 * stats.t.sf(abs(mean / error), freedom))
            half = error * stats.t.ppf(0.975, freedom)
            expect("interval between clusters", ["t_interval", sums.tolist(), pairs.tolist(), 0.05], [mean - half, mean + half])
        expect("t, clusters of one size", ["t_test", sums.tolist(), [6.0] * n], stats.ttest_1samp(sums, 0).pvalue)
        if n <= 12:
            expect("sign flips", ["sign_flip", sums.tolist()], enumerated(sums))


def bootstrap():
    values = random.gamma(2, 1, 999)
    expect("percentiles", ["percentile", values.tolist(), 0.05], np.quantile(values, [0.025, 0.975]))


def t_power(shift, n, level):
    """By integration over what the variance may come out as; SciPy's noncentral t would be the same Boost code as ours."""
    bound, shift = stats.t.ppf(1 - level / 2, n - 1), shift * np.sqrt(n)

    def found(variance):
        scaled = bound * np.sqrt(variance / (n - 1))
        return stats.chi2.pdf(variance, n - 1) * (stats.norm.sf(scaled - shift) + stats.norm.cdf(-scaled - shift))

    middle = max(n - 1, 1)
    return sum(integrate.quad(found, *ends, limit=500, epsabs=1e-11)[0]
               for ends in ((0, middle), (middle, middle + 40 + 12 * np.sqrt(2 * n))))


def power():
    for shift, n, level in [(0.5, 2, 0.05), (0.5, 7, 0.05), (1.2, 7, 0.01), (0.3, 40, 0.05), (0.1, 500, 0.05), (0.02, 1500, 0.017)]:
        expect("power", ["power", shift, n, level], t_power(shift, n, level))
    for shift, level in [(1.5, 0.05), (0.5, 0.05), (0.2, 0.01), (0.08, 0.05)]:
        low, n = 1, 2000
        while n - low > 1:
            middle = (low + n) // 2
            low, n = (middle, n) if t_power(shift, middle, level) < 0.8 else (low, middle)
        expect("units for power 0.8", ["units", shift, level, 0.8], n)


def looks():
    """Two looks by integration of the bivariate normal distribution."""
    z = stats.norm.ppf(1 - 0.05 / 4)  # half of the level on either side

    def spent(t):
        return 4 * stats.norm.sf(z / np.sqrt(t))

    first = stats.norm.isf(spent(0.5) / 2)

    def beyond(second):
        inside = integrate.quad(lambda u: stats.norm.pdf(u, 0, np.sqrt(0.5)) * (
            stats.norm.sf((second - u) / np.sqrt(0.5)) + stats.norm.cdf((-second - u) / np.sqrt(0.5))),
            -first * np.sqrt(0.5), first * np.sqrt(0.5), epsabs=1e-12)
        return inside[0]

    low, high = 1.5, 3.0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if beyond(middle) > 0.05 - spent(0.5) else (low, middle)
    expect("two looks", ["looks", 0.05, [0.5, 1.0]], [spent(0.5), 2 * stats.norm.sf(low)])


def answers(tool):
    requests = "".join(json.dumps(request) + "\n" for request, _, _ in cases)
    lines = subprocess.run([tool], input=requests, capture_output=True, text=True, check=True).stdout.splitlines()
    return [np.array([np.inf if x is None else x for x in np.atleast_1d(json.loads(line))], float) for line in lines]


def main():
    for make in (mcnemar, wilcoxon, holm, clusters, bootstrap, power, looks):
        make()
    failed = 0
    for (request, expected, what), answer in zip(cases, answers(sys.argv[1]), strict=True):
        close = answer.shape == expected.shape and np.allclose(answer, expected, rtol=TOLERANCE, atol=TOLERANCE)
        if not close:
            failed += 1
            print(f"{what}: {str(request)[:200]}: {answer}, expected {expected}")
    print(f"{len(cases) - failed} of {len(cases)} answers agree to {TOLERANCE}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
