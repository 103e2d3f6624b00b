//! Count, median, 99th percentile and maximum.

/// Of one measure over some rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Summary {
    pub count: usize,
    pub median: f64,
    pub p99: f64,
    pub max: f64,
    /// The row of the maximum.
    pub row: String,
}

/// `None` where there is nothing to sum up. NaN, for what was not measured, is left out.
pub fn summary<'a>(errors: impl Iterator<Item = (f64, &'a str)>) -> Option<Summary> {
    let mut sorted: Vec<_> = errors.filter(|(error, _)| !error.is_nan()).collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    let &(max, row) = sorted.last()?;
    let at = |share: f64| sorted[rank(sorted.len(), share)].0;
    Some(Summary { count: sorted.len(), median: at(0.5), p99: at(0.99), max, row: row.to_owned() })
}

/// The index in sorted order below or at which that share of `count` lies.
pub fn rank(count: usize, share: f64) -> usize {
    ((count as f64 * share).ceil() as usize).clamp(1, count) - 1
}
