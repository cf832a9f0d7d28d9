//! Logix controllers, by EtherNet/IP.
