//! The fingerprint of a picture: equal for the same scene and settings on every machine.

use sha2::{Digest, Sha256};

/// SHA-256 of a linear picture, in hexadecimal: its f32 values as little-endian bytes, red, green and blue of each
/// pixel, rows from the top.
#[must_use]
pub fn linear_hash(rgb: &[f32]) -> String {
    // Not all at once: the bytes of a large picture would take as much memory as the picture.
    const VALUES: usize = 4096;
    let mut hash = Sha256::new();
    let mut bytes = Vec::with_capacity(VALUES.saturating_mul(4));
    for values in rgb.chunks(VALUES) {
        bytes.clear();
        bytes.extend(values.iter().flat_map(|v| v.to_le_bytes()));
        hash.update(&bytes);
    }
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_hashes() {
        assert_eq!(linear_hash(&[]), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
        // python3: hashlib.sha256(struct.pack('<3f', 0.0, 1.0, 0.5)).hexdigest()
        assert_eq!(linear_hash(&[0.0, 1.0, 0.5]), "9b5992a7d8f992e90b7ff71b42669586b73fe79351f49b2ae064ddca9666233b");
        // python3: hashlib.sha256(struct.pack('<9000f', *[i / 8 for i in range(9000)])).hexdigest()
        let many: Vec<f32> = (0..9000_u16).map(|i| f32::from(i) / 8.0).collect();
        assert_eq!(linear_hash(&many), "92c48c836aab24630899d82ea9beb042ce454a9db1442023da9dbd97fd7ed948");
    }

    #[test]
    fn one_bit_more_is_another_hash() {
        assert_ne!(linear_hash(&[1.0]), linear_hash(&[1.0_f32.next_up()]));
        assert_ne!(linear_hash(&[0.0]), linear_hash(&[-0.0]), "bits, not values");
    }
}
