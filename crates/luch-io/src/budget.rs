//! What one load may spend: bytes of memory, and the patience of the user.

use crate::error::{Error, ErrorKind, Result};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// A memory limit that is charged before each large allocation, and a flag that stops the load.
///
/// Out of memory cannot be caught, and most systems hand out more than they have: so the need is compared with a
/// stated limit first. Bookkeeping is in bytes of list capacity, which is an upper bound of what is touched.
#[derive(Debug, Clone)]
pub struct Budget {
    limit: u64,
    used: u64,
    peak: u64,
    cancel: Option<Arc<AtomicBool>>,
}

/// A charge that went over the limit; becomes an [`Error`] when the file is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OverBudget {
    /// What the memory was for.
    pub what: &'static str,
    /// Bytes in use, were it granted.
    pub needed: u64,
    /// Bytes that may be used.
    pub limit: u64,
}

impl Budget {
    /// The limit where the machine does not say how much memory it has: 8 GiB.
    pub const FALLBACK_LIMIT: u64 = 8 << 30;

    /// A budget of so many bytes.
    #[must_use]
    pub const fn new(limit: u64) -> Self {
        Self { limit, used: 0, peak: 0, cancel: None }
    }

    /// The same budget, stopped when `flag` becomes true.
    #[must_use]
    pub fn cancelled_by(mut self, flag: Arc<AtomicBool>) -> Self {
        self.cancel = Some(flag);
        self
    }

    /// Bytes that may be used in all.
    #[must_use]
    pub const fn limit(&self) -> u64 {
        self.limit
    }

    /// Bytes in use now.
    #[must_use]
    pub const fn used(&self) -> u64 {
        self.used
    }

    /// The most bytes that were in use at one time.
    #[must_use]
    pub const fn peak(&self) -> u64 {
        self.peak
    }

    /// Whether the user asked to stop. Readers poll it about once a megabyte.
    #[must_use]
    pub fn is_cancelled(&self) -> bool {
        self.cancel.as_ref().is_some_and(|flag| flag.load(Ordering::Relaxed))
    }

    /// # Errors
    /// [`ErrorKind::Cancelled`] if the user asked to stop.
    pub fn check_cancelled(&self, file: &Path) -> Result<()> {
        if self.is_cancelled() { Err(Error::new(ErrorKind::Cancelled, file, "stopped while reading")) } else { Ok(()) }
    }

    /// Charges `bytes` before they are allocated.
    ///
    /// # Errors
    /// [`OverBudget`] if the limit would be exceeded; then nothing is charged.
    pub fn charge(&mut self, what: &'static str, bytes: u64) -> std::result::Result<(), OverBudget> {
        let needed = self.used.saturating_add(bytes);
        if needed > self.limit {
            return Err(OverBudget { what, needed, limit: self.limit });
        }
        self.used = needed;
        self.peak = self.peak.max(needed);
        Ok(())
    }

    /// Gives back bytes that were charged.
    pub const fn release(&mut self, bytes: u64) {
        self.used = self.used.saturating_sub(bytes);
    }

    /// Makes room for at least `additional` more items in `list` and charges for the new capacity.
    ///
    /// # Errors
    /// [`OverBudget`] if the limit would be exceeded, or if the system refuses the memory.
    pub fn reserve<T>(
        &mut self,
        list: &mut Vec<T>,
        additional: usize,
        what: &'static str,
    ) -> std::result::Result<(), OverBudget> {
        let wanted = list.len().saturating_add(additional);
        if wanted <= list.capacity() {
            return Ok(());
        }
        let bytes = bytes_of::<T>(wanted.saturating_sub(list.capacity()));
        self.charge(what, bytes)?;
        if list.try_reserve_exact(additional).is_err() {
            self.release(bytes);
            return Err(OverBudget { what, needed: self.used.saturating_add(bytes), limit: self.limit });
        }
        Ok(())
    }

    /// Gives back what `list` was charged for; call it when the list is dropped.
    pub fn release_list<T>(&mut self, list: &[T], capacity: usize) {
        self.release(bytes_of::<T>(capacity.max(list.len())));
    }
}

impl Default for Budget {
    /// Three quarters of the machine's memory, or the control group's limit if that is less, or
    /// [`Budget::FALLBACK_LIMIT`] where neither is known.
    fn default() -> Self {
        Self::new(machine_limit().unwrap_or(Self::FALLBACK_LIMIT))
    }
}

impl OverBudget {
    /// The error of a file that needs too much.
    #[must_use]
    pub fn in_file(self, file: &Path) -> Error {
        let text = format!(
            "needs {} of memory for {}, the limit is {}",
            human_bytes(self.needed),
            self.what,
            human_bytes(self.limit)
        );
        Error::new(ErrorKind::Limit, file, text).hint("--memory raises the limit")
    }
}

/// Bytes of `count` items, saturating.
fn bytes_of<T>(count: usize) -> u64 {
    let size = u64::try_from(size_of::<T>()).unwrap_or(u64::MAX);
    u64::try_from(count).unwrap_or(u64::MAX).saturating_mul(size)
}

/// A number of bytes for people: `512 bytes`, `1.5 MiB`.
#[must_use]
pub fn human_bytes(bytes: u64) -> String {
    let units = [(30, "GiB"), (20, "MiB"), (10, "KiB")];
    for (shift, unit) in units {
        if bytes >> shift > 0 {
            // Tenths, rounded up: a need must not be told smaller than it is.
            let tenths = u128::from(bytes).saturating_mul(10).div_ceil(1_u128 << shift);
            return format!("{}.{} {unit}", tenths / 10, tenths % 10);
        }
    }
    format!("{bytes} bytes")
}

/// Linux: the smaller of 75 % of the memory and the control group's limit.
fn machine_limit() -> Option<u64> {
    let meminfo = std::fs::read_to_string("/proc/meminfo").ok();
    let total = meminfo.as_deref().and_then(total_of_meminfo).map(|bytes| (bytes / 4).saturating_mul(3));
    let group = ["/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"]
        .into_iter()
        .find_map(|path| std::fs::read_to_string(path).ok()?.trim().parse::<u64>().ok());
    match (total, group) {
        (Some(a), Some(b)) => Some(a.min(b)),
        (a, b) => a.or(b),
    }
}

/// `MemTotal:  24675920 kB` in bytes.
fn total_of_meminfo(text: &str) -> Option<u64> {
    let line = text.lines().find_map(|line| line.strip_prefix("MemTotal:"))?;
    line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok()?.checked_mul(1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_goes_over_the_limit_is_refused_and_not_charged() {
        let mut budget = Budget::new(1000);
        budget.charge("vertices", 600).unwrap();
        let over = budget.charge("faces", 500).unwrap_err();
        assert_eq!((over.needed, over.limit, budget.used()), (1100, 1000, 600));
        let error = over.in_file(Path::new("a.obj"));
        assert_eq!(error.kind, ErrorKind::Limit);
        assert_eq!(error.text, "needs 1.1 KiB of memory for faces, the limit is 1000 bytes");
        assert!(error.hint.unwrap().contains("--memory"));
        budget.release(600);
        budget.charge("faces", 1000).unwrap();
        assert_eq!(budget.peak(), 1000);
    }

    #[test]
    fn sums_beyond_u64_are_refused_not_wrapped() {
        let mut budget = Budget::new(u64::MAX - 1);
        budget.charge("x", 10).unwrap();
        assert!(budget.charge("x", u64::MAX).is_err());
    }

    #[test]
    fn lists_are_charged_for_their_capacity() {
        let mut budget = Budget::new(100);
        let mut list: Vec<u32> = Vec::new();
        budget.reserve(&mut list, 10, "numbers").unwrap();
        assert_eq!((list.capacity(), budget.used()), (10, 40));
        budget.reserve(&mut list, 10, "numbers").unwrap();
        assert_eq!(budget.used(), 40, "room that is there costs nothing");
        assert!(budget.reserve(&mut list, 26, "numbers").is_err());
        budget.release_list(&list, list.capacity());
        assert_eq!(budget.used(), 0);
    }

    #[test]
    fn the_default_limit_is_of_this_machine() {
        assert_eq!(total_of_meminfo("MemTotal:  2 kB\nMemFree: 1 kB\n"), Some(2048));
        assert_eq!(total_of_meminfo("nonsense"), None);
        assert!(Budget::default().limit() > 64 << 20);
    }

    #[test]
    fn a_flag_cancels() {
        let flag = Arc::new(AtomicBool::new(false));
        let budget = Budget::new(1).cancelled_by(Arc::clone(&flag));
        assert!(budget.check_cancelled(Path::new("a")).is_ok());
        flag.store(true, Ordering::Relaxed);
        assert_eq!(budget.check_cancelled(Path::new("a")).unwrap_err().kind, ErrorKind::Cancelled);
    }
}
