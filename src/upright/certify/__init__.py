"""May this controller drive this robot? The certificate and what it tries."""

from upright.certify.certificate import Certificate as Certificate
from upright.certify.certificate import certify as certify
from upright.certify.certificate import read_certificate as read_certificate
